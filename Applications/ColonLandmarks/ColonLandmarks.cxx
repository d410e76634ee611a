#include "ColonLandmarksXML.h"

#include "shapetonColonLandmarkFiles.h"
#include "shapetonColonLandmarkReport.h"
#include "shapetonCommandLine.h"
#include "shapetonReadOptions.h"
#include "shapetonToolSurfaces.h"
#include "shapetonToolVolumes.h"

#include <optional>

namespace
{
using namespace shapeton;

ColonLandmarkSettings
SettingsOf(CommandLine & commandLine)
{
  ColonLandmarkSettings settings;
  ReadOptions(commandLine, settings);
  if (commandLine.IsGiven("markers"))
  {
    settings.markers = ReadTaeniaMarkers(commandLine, "markers");
  }
  if (commandLine.IsGiven("registration"))
  {
    settings.taeniaNumbers = ReadTaeniaNumbers(commandLine, "registration");
  }
  if (commandLine.IsGiven("volume"))
  {
    commandLine.Progress("Finding the pelvis", 0.0);
    const Volume volume = ReadVolume(commandLine, "volume");
    WarnUnlessCT(commandLine, volume);
    settings.pelvis = FindPelvis(volume.image);
  }
  settings.progress = commandLine.PartOfProgress(0.0, 0.7); // the rest: splitting the colon and writing the files
  return settings;
}

void
Mark(CommandLine & commandLine)
{
  const ColonLandmarkFiles    files(commandLine, commandLine.GetString("outputFolder"));
  const std::string           report = commandLine.MakeFolderOf("report");
  const ColonLandmarkSettings settings = SettingsOf(commandLine);
  const CurveSet              centerline = ReadCurves(commandLine, "inputCenterline");
  const FlatColon             flat(ReadSurface(commandLine, "inputFlat").mesh);
  const ColonLandmarks        landmarks = FindColonLandmarks(flat, centerline, settings);
  commandLine.Warn(landmarks.warnings);

  std::optional<ColonPieces> pieces;
  if (commandLine.GetFlag("split"))
  {
    commandLine.Progress("Splitting", 0.7);
    pieces = SplitColon(flat.Surface(), landmarks);
    commandLine.Warn(pieces->warnings);
  }
  commandLine.Progress("Writing", 0.9);
  files.Write(flat.Surface(), landmarks, pieces ? &*pieces : nullptr);
  WriteColonLandmarkReport(commandLine, report, flat, landmarks, pieces ? &*pieces : nullptr);
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Mark);
}
