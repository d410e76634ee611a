#include "ColonLandmarksXML.h"

#include "itkColonLandmarkFiles.h"
#include "itkColonLandmarkReport.h"
#include "itkCommandLine.h"
#include "itkSurfaceReader.h"

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
  options.progress = [&commandLine](const std::string & stage, double share) {
    constexpr double landmarksEnd = 0.7; // then the colon is split and the files are written
    commandLine.Progress(stage, landmarksEnd * share);
  };
  return options;
}

void
WarnAll(CommandLine & commandLine, const std::vector<std::string> & warnings)
{
  for (const std::string & warning : warnings)
  {
    commandLine.Warn(warning);
  }
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
  WarnAll(commandLine, landmarks.warnings);

  std::optional<itk::ColonPieces> pieces;
  if (commandLine.GetFlag("split"))
  {
    commandLine.Progress("Splitting", 0.7);
    pieces = itk::SplitColon(flat, landmarks);
    WarnAll(commandLine, pieces->warnings);
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
