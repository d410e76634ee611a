#include "ColonLandmarksXML.h"

#include "shapetonColonLandmarkFiles.h"
#include "shapetonColonLandmarkReport.h"
#include "shapetonCommandLine.h"
#include "shapetonToolSurfaces.h"

#include <optional>

namespace
{
using shapeton::CommandLine;

shapeton::ColonLandmarkOptions
OptionsOf(CommandLine & commandLine)
{
  shapeton::ColonLandmarkOptions options;
  options.flexureRule = commandLine.GetString("flexureRule") == "published" ? shapeton::FlexureRule::Published
                                                                            : shapeton::FlexureRule::Ordered;
  options.taeniaRule =
    commandLine.GetString("taeniaRule") == "published" ? shapeton::TaeniaRule::Published : shapeton::TaeniaRule::Joint;
  if (commandLine.IsGiven("markers"))
  {
    options.markers = shapeton::ReadTaeniaMarkers(commandLine, "markers");
  }
  options.progress = commandLine.PartOfProgress(0.0, 0.7); // the rest: splitting the colon and writing the files
  return options;
}

void
Mark(CommandLine & commandLine)
{
  const shapeton::ColonLandmarkFiles   files(commandLine, commandLine.GetString("outputFolder"));
  const shapeton::ColonLandmarkReport  report(commandLine, commandLine.GetString("report"));
  const shapeton::ColonLandmarkOptions options = OptionsOf(commandLine);
  const shapeton::CurveSet             centerline = shapeton::ReadCurves(commandLine, "inputCenterline");
  const shapeton::FlatColon            flat(shapeton::ReadSurface(commandLine, "inputFlat").mesh);
  const shapeton::ColonLandmarks       landmarks = shapeton::FindColonLandmarks(flat, centerline, options);
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
