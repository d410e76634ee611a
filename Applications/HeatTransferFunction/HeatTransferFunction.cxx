#include "HeatTransferFunctionXML.h"

#include "itkCommandLine.h"
#include "itkHeatClassification.h"
#include "itkHeatReport.h"
#include "itkHeatSnapshot.h"
#include "itkShapetonResultFiles.h"
#include "itkToolError.h"
#include "itkTransferFunctionPicture.h"
#include "itkVisitDensity.h"
#include "itkVolumeReader.h"

#include <filesystem>

namespace
{
using ImageType = itk::Image<float, 3>;
using VisitsType = itk::Image<std::uint32_t, 3>;

/** The intensities and the heat, or what shapetons visited, on one grid. */
struct Volumes
{
  itk::Volume                  input;
  ImageType::Pointer           heat;   // or the density of visits
  VisitsType::Pointer          visits; // null for heat
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
  volumes.visits = itk::VisitsOf(heat.image, snapshot);
  volumes.heat = volumes.visits ? itk::NormalizeVisits(volumes.visits) : heat.image;
  itk::RequireHeat(volumes.heat, snapshot.path);
  if (!itk::HaveSameGrid(volumes.input.image, volumes.heat))
  {
    throw itk::InputError("the grids of " + commandLine.GetString("inputVolume") + " and " + snapshot.path +
                          " differ in size or place: give the volume that the heat was computed from");
  }
  return volumes;
}

itk::ShapeQuantity
QuantityOf(const Volumes & volumes)
{
  return volumes.visits ? itk::ShapeQuantity::Density(itk::GreatestVisits(volumes.visits)) : itk::ShapeQuantity();
}

/** The histogram of the volume, its classes, and the histogram that lays out axis and colours. */
struct Analysis
{
  itk::HeatHistogram          histogram;
  std::vector<itk::HeatClass> classes;
  itk::HeatHistogram          axis;
};

Analysis
Analyse(const Volumes & volumes)
{
  Analysis analysis;
  analysis.histogram = itk::HeatHistogram({ volumes.timeStep.value_or(0) });
  if (volumes.visits)
  {
    itk::AddVisitsToRow(volumes.visits, 0, analysis.histogram);
    analysis.classes = itk::ClassifyVisits(volumes.visits, volumes.heat).classes;
    analysis.axis = itk::BalanceClasses(analysis.histogram, 0, analysis.classes);
    return analysis;
  }
  analysis.histogram.AddToRow(
    0, volumes.heat->GetBufferPointer(), volumes.heat->GetBufferedRegion().GetNumberOfPixels());
  analysis.classes = itk::FindHeatClasses(analysis.histogram, 0);
  itk::LabelHeat(volumes.heat, analysis.classes);
  analysis.axis = analysis.histogram;
  return analysis;
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
  const std::string title = QuantityOf(volumes).GetTitle();
  return volumes.timeStep ? title + " after " + std::to_string(*volumes.timeStep) + " time steps" : title;
}

void
WriteReport(itk::CommandLine &                 commandLine,
            const Volumes &                    volumes,
            const Analysis &                   analysis,
            const itk::ShapeTransferFunction & transferFunction)
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
  content.quantity = QuantityOf(volumes);
  content.readingGuide = volumes.visits ? itk::ReadingGuideOfVisits() : itk::ReadingGuideOfHeat();
  content.histogram = &analysis.histogram;
  content.axisHistogram = &analysis.axis;
  content.grey = volumes.input.image;
  content.heat = volumes.heat;
  content.timeStep = volumes.timeStep;
  content.classes = analysis.classes;
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
  const Analysis analysis = Analyse(volumes);
  const auto     quantity = QuantityOf(volumes);
  const auto     transferFunction =
    lines ? *lines : LinesOfClasses(commandLine, analysis.classes, itk::HeatAxis(analysis.axis));
  transferFunction.WriteVolumeProperty(propertyFile, std::max(1U, quantity.greatestVisits));
  commandLine.Progress("Drawing", 0.6);
  if (!pictureFile.empty())
  {
    itk::WritePng(
      itk::DrawTransferFunction(volumes.input.image, volumes.heat, transferFunction, TitleOf(volumes), {}, quantity),
      pictureFile);
  }
  if (commandLine.IsGiven("report"))
  {
    WriteReport(commandLine, volumes, analysis, transferFunction);
  }
  commandLine.RecordRun(output + ".run.json");
}
} // namespace

int
main(int argc, char * argv[])
{
  return itk::CommandLine::Run(ToolXML, argc, argv, MakeTransferFunction);
}
