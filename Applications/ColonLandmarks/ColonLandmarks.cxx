#include "ColonLandmarksXML.h"

#include "itkColonLandmarkFiles.h"
#include "itkColonLandmarkReport.h"
#include "itkCommandLine.h"
#include "itkToolSurfaces.h"

#include <optional>

namespace
{
using itk::CommandLine;

itk::ColonLandmarkOptions
OptionsOf(CommandLine & commandLine)
{
  itk::ColonLandmarkOptions options;
  options.flexureRule =
    commandLine.GetString("flexureRule") == "published" ? itk::FlexureRule::Published : itk::FlexureRule::Ordered;
  options.taeniaRule =
    commandLine.GetString("taeniaRule") == "published" ? itk::TaeniaRule::Published : itk::TaeniaRule::Joint;
  if (commandLine.IsGiven("markers"))
  {
    options.markers = itk::ReadTaeniaMarkers(commandLine, "markers");
  }
  options.progress = commandLine.PartOfProgress(0.0, 0.7); // then the colon is split and the files are written
  return options;
}

void
Mark(CommandLine & commandLine)
{
  const itk::ColonLandmarkFiles   files(commandLine, commandLine.GetString("outputFolder"));
  const itk::ColonLandmarkReport  report(commandLine, commandLine.GetString("report"));
  const itk::ColonLandmarkOptions options = OptionsOf(commandLine);
  const itk::CurveSet             centreline = itk::ReadCurves(commandLine, "inputCentreline");
  const itk::SurfaceMesh          flat = itk::ReadSurface(commandLine, "inputFlat").mesh;
  const itk::ColonLandmarks       landmarks = itk::FindColonLandmarks(flat, centreline, options);
  commandLine.Warn(landmarks.warnings);

  std::optional<itk::ColonPieces> pieces;
  if (commandLine.GetFlag("split"))
  {
    commandLine.Progress("Splitting", 0.7);
    pieces = itk::SplitColon(flat, landmarks);
    commandLine.Warn(pieces->warnings);
  }
  commandLine.Progress("Writing", 0.9);
  files.Write(flat, landmarks, pieces ? &*pieces : nullptr);
  report.Write(flat, landmarks, pieces ? &*pieces : nullptr);
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Mark);
}
