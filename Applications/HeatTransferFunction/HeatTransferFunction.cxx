#include "HeatTransferFunctionXML.h"

#include "itkCommandLine.h"
#include "itkHeatClassification.h"
#include "itkHeatReport.h"
#include "itkHeatSnapshot.h"
#include "itkToolError.h"
#include "itkTransferFunctionPicture.h"
#include "itkVolumeReader.h"

#include <filesystem>

namespace
{
using ImageType = itk::Image<float, 3>;

/** The intensities and the heat, on one grid. */
struct Volumes
{
  itk::Volume                  input;
  ImageType::Pointer           heat;
  std::optional<std::uint64_t> timeStep;
};

Volumes
ReadVolumes(itk::CommandLine & commandLine)
{
  const int  timeStep = commandLine.GetInteger("timeStep");
  const auto snapshot = itk::FindHeatSnapshot(commandLine.GetString("heatVolume"),
                                              timeStep < 0 ? std::nullopt : std::optional<std::uint64_t>(timeStep));
  Volumes    volumes;
  volumes.timeStep = snapshot.timeStep;
  if (!snapshot.timeStep)
  {
    commandLine.Warn("the header of " + std::filesystem::path(snapshot.path).filename().string() +
                     " does not state its time step: the pictures cannot tell it");
  }
  volumes.input = itk::ReadVolume(commandLine, "inputVolume");
  commandLine.Progress("Reading", 0.2);
  const itk::Volume heat = itk::ReadVolume(snapshot.path);
  commandLine.AddInput("heatVolume", heat.identity);
  volumes.heat = heat.image;
  itk::RequireHeat(volumes.heat, snapshot.path);
  if (!itk::HaveSameGrid(volumes.input.image, volumes.heat))
  {
    throw itk::InputError("the grids of " + commandLine.GetString("inputVolume") + " and " + snapshot.path +
                          " differ in size or place: give the volume that the heat was computed from");
  }
  return volumes;
}

itk::HeatHistogram
HistogramOf(const Volumes & volumes)
{
  itk::HeatHistogram histogram({ volumes.timeStep.value_or(0) });
  histogram.AddToRow(0, volumes.heat->GetBufferPointer(), volumes.heat->GetBufferedRegion().GetNumberOfPixels());
  return histogram;
}

/** The lines that the user gave, if any. */
std::optional<itk::ShapeTransferFunction>
ParseLines(const itk::CommandLine & commandLine)
{
  const std::string lines = commandLine.GetString("lines");
  return lines.empty() ? std::nullopt : std::make_optional(itk::ShapeTransferFunction::Parse(lines));
}

itk::ShapeTransferFunction
LinesOfClasses(itk::CommandLine & commandLine, const std::vector<itk::HeatClass> & classes, const itk::HeatAxis & axis)
{
  auto transferFunction = itk::ShapeTransferFunction::FromClasses(classes, axis);
  if (transferFunction.GetLines().empty())
  {
    commandLine.Warn("the heat volume holds nothing but background: the transfer function shows nothing");
  }
  return transferFunction;
}

std::string
TitleOf(const Volumes & volumes)
{
  return volumes.timeStep ? "Heat after " + std::to_string(*volumes.timeStep) + " time steps" : "Heat";
}

void
WriteReport(itk::CommandLine &                  commandLine,
            const Volumes &                     volumes,
            const itk::HeatHistogram &          histogram,
            const std::vector<itk::HeatClass> & classes,
            const itk::ShapeTransferFunction &  transferFunction)
{
  const std::string folder = commandLine.GetString("report");
  commandLine.MakeFolder(folder);
  itk::HeatReportContent content;
  content.title = "Shape-based transfer function";
  content.input = { { "Modality", volumes.input.modality }, { "Identity", volumes.input.identity } };
  content.parameters = { { "Lines", transferFunction.ToText() },
                         { "Time step", volumes.timeStep ? std::to_string(*volumes.timeStep) : "not known" } };
  content.provenance = commandLine.GetProvenance();
  content.warnings = commandLine.GetWarnings();
  content.histogram = &histogram;
  content.grey = volumes.input.image;
  content.heat = volumes.heat;
  content.timeStep = volumes.timeStep;
  content.classes = classes;
  content.transferFunction = transferFunction;
  itk::WriteHeatReport(content, folder, [&](const std::string & path) { return commandLine.Output(path); });
}

void
MakeTransferFunction(itk::CommandLine & commandLine)
{
  const std::string output = commandLine.GetString("volumeProperty");
  if (std::filesystem::path(output).extension() != ".vp")
  {
    throw itk::UsageError("the output " + output +
                          " needs the extension .vp, by which 3D Slicer knows a volume property");
  }
  const auto        lines = ParseLines(commandLine);
  const std::string propertyFile = commandLine.Output(output);
  const std::string pictureFile = commandLine.OutputOf("picture");

  const Volumes volumes = ReadVolumes(commandLine);
  commandLine.Progress("Classifying", 0.5);
  const itk::HeatHistogram    histogram = HistogramOf(volumes);
  std::vector<itk::HeatClass> classes = itk::FindHeatClasses(histogram, 0);
  itk::LabelHeat(volumes.heat, classes);
  const auto transferFunction = lines ? *lines : LinesOfClasses(commandLine, classes, itk::HeatAxis(histogram));
  transferFunction.WriteVolumeProperty(propertyFile);
  commandLine.Progress("Drawing", 0.6);
  if (!pictureFile.empty())
  {
    itk::WritePng(itk::DrawTransferFunction(volumes.input.image, volumes.heat, transferFunction, TitleOf(volumes)),
                  pictureFile);
  }
  if (commandLine.IsGiven("report"))
  {
    WriteReport(commandLine, volumes, histogram, classes, transferFunction);
  }
  commandLine.RecordRun(output + ".run.json");
}
} // namespace

int
main(int argc, char * argv[])
{
  return itk::CommandLine::Run(ToolXML, argc, argv, MakeTransferFunction);
}
