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
using shapeton::CommandLine;

shapeton::ColonLandmarkSettings
SettingsOf(CommandLine & commandLine)
{
  shapeton::ColonLandmarkSettings settings;
  shapeton::ReadOptions(commandLine, settings);
  if (commandLine.IsGiven("markers"))
  {
    settings.markers = shapeton::ReadTaeniaMarkers(commandLine, "markers");
  }
  if (commandLine.IsGiven("volume"))
  {
    commandLine.Progress("Finding the pelvis", 0.0);
    const shapeton::Volume volume = shapeton::ReadVolume(commandLine, "volume");
    shapeton::WarnUnlessCT(commandLine, volume);
    settings.pelvis = shapeton::FindPelvis(volume.image);
  }
  settings.progress = commandLine.PartOfProgress(0.0, 0.7); // the rest: splitting the colon and writing the files
  return settings;
}

void
Mark(CommandLine & commandLine)
{
  const shapeton::ColonLandmarkFiles    files(commandLine, commandLine.GetString("outputFolder"));
  const shapeton::ColonLandmarkReport   report(commandLine, commandLine.GetString("report"));
  const shapeton::ColonLandmarkSettings settings = SettingsOf(commandLine);
  const shapeton::CurveSet              centerline = shapeton::ReadCurves(commandLine, "inputCenterline");
  const shapeton::FlatColon             flat(shapeton::ReadSurface(commandLine, "inputFlat").mesh);
  const shapeton::ColonLandmarks        landmarks = shapeton::FindColonLandmarks(flat, centerline, settings);
  commandLine.Warn(landmarks.warnings);

  std::optional<shapeton::ColonPieces> pieces;
  if (commandLine.GetFlag("split"))
  {
    commandLine.Progress("Splitting", 0.7);
    pieces = shapeton::SplitColon(flat.Surface(), landmarks);
    commandLine.Warn(pieces->warnings);
  }
  commandLine.Progress("Writing", 0.9);
  files.Write(flat.Surface(), landmarks, pieces ? &*pieces : nullptr);
  report.Write(flat, landmarks, pieces ? &*pieces : nullptr);
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Mark);
}
