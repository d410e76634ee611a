#include "HeatTransferFunctionXML.h"

#include "shapetonCommandLine.h"
#include "shapetonHeatClassification.h"
#include "shapetonHeatReport.h"
#include "shapetonHeatSnapshot.h"
#include "shapetonShapeAnalysis.h"
#include "shapetonExceptions.h"
#include "shapetonImageGrid.h"
#include "shapetonTransferFunctionChoice.h"
#include "shapetonTransferFunctionPicture.h"
#include "shapetonToolDevice.h"
#include "shapetonToolVolumes.h"

#include <filesystem>

namespace
{
using namespace shapeton;

using ImageType = itk::Image<float, 3>;

/** The intensities and the heat, or the visits of shapetons, on one grid. */
struct Volumes
{
  Volume                       input;
  ShapeAnalysis                shape;
  std::optional<std::uint64_t> timeStep;
};

Volumes
ReadVolumes(CommandLine & commandLine, const TransferFunctionChoice & choice)
{
  const auto snapshot = FindHeatSnapshot(commandLine.GetString("heatVolume"), choice.timeStep);
  Volumes    volumes;
  volumes.timeStep = snapshot.timeStep;
  if (!snapshot.timeStep)
  {
    commandLine.Warn("the header of " + std::filesystem::path(snapshot.path).filename().string() +
                     " has no time step: the pictures cannot show it");
  }
  volumes.input = ReadVolume(commandLine, "inputVolume");
  commandLine.Progress("Reading", 0.2);
  const Volume heat = ReadVolume(snapshot.path);
  commandLine.AddInput("heatVolume", heat.identity);
  const auto visits = VisitsOf(heat.image, snapshot);
  if (!visits)
  {
    RequireHeat(heat.image, snapshot.path);
  }
  if (!HaveSameGrid(volumes.input.image, heat.image))
  {
    throw InputError("the grids of " + commandLine.GetString("inputVolume") + " and " + snapshot.path +
                     " differ; use the volume from which the heat was computed");
  }
  commandLine.Progress("Classifying", 0.5);
  const std::uint64_t step = volumes.timeStep.value_or(0);
  volumes.shape = visits ? AnalyzeVisits(visits, step) : AnalyzeHeat(heat.image, step);
  RequireQuantity(choice, volumes.shape.quantity, snapshot.path);
  return volumes;
}

ShapeTransferFunction
LinesOfClasses(CommandLine & commandLine, const ShapeAnalysis & shape)
{
  auto transferFunction = ShapeTransferFunction::FromClasses(shape.classes);
  if (transferFunction.GetLines().empty())
  {
    commandLine.Warn("the heat volume contains only background: the transfer function is empty");
  }
  return transferFunction;
}

std::string
TitleOf(const Volumes & volumes)
{
  const std::string title = volumes.shape.quantity.GetTitle();
  return volumes.timeStep ? title + " after " + std::to_string(*volumes.timeStep) + " time steps" : title;
}

void
WriteReport(CommandLine &                 commandLine,
            const Volumes &               volumes,
            const ShapeTransferFunction & transferFunction,
            const ColoredClasses &        drawn,
            const VolumeRenderer &        renderer)
{
  const std::string folder = commandLine.MakeFolderOf("report");
  HeatReportContent content;
  content.title = "Shape-based transfer function";
  content.input = { { "Modality", volumes.input.modality }, { "Identity", volumes.input.identity } };
  content.parameters = { { "Lines", transferFunction.ToText() },
                         { "Time step", volumes.timeStep ? std::to_string(*volumes.timeStep) : "not known" } };
  content.provenance = commandLine.GetProvenance();
  content.warnings = commandLine.GetWarnings();
  content.quantity = volumes.shape.quantity;
  content.histogram = &volumes.shape.histogram;
  content.axisHistogram = &volumes.shape.axisHistogram;
  content.gray = volumes.input.image;
  content.heat = volumes.shape.values;
  content.timeStep = volumes.timeStep;
  content.classes = volumes.shape.classes;
  content.transferFunction = transferFunction;
  content.drawn = drawn;
  content.renderer = &renderer;
  WriteHeatReport(content, folder, [&](const std::string & path) { return commandLine.Output(path); });
}

void
MakeTransferFunction(CommandLine & commandLine)
{
  const auto        choice = ReadTransferFunctionChoice(commandLine);
  const std::string propertyFile = commandLine.MainOutput("volumeProperty");
  const std::string pictureFile = commandLine.OutputOf("picture");

  const Volumes volumes = ReadVolumes(commandLine, choice);
  const auto &  shape = volumes.shape;
  const auto    transferFunction = choice.lines ? *choice.lines : LinesOfClasses(commandLine, shape);
  transferFunction.WriteVolumeProperty(propertyFile, std::max(1U, shape.quantity.greatestVisits));
  commandLine.Progress("Drawing", 0.6);
  const auto           drawn = ColorChoice(commandLine, choice, shape.values, transferFunction);
  const VolumeRenderer renderer(drawn.values, drawn.lines, ReadDevice(commandLine));
  commandLine.AddRunFact("device", renderer.GetDeviceUse().Describe());
  if (!pictureFile.empty())
  {
    const auto & gray = volumes.input.image;
    const auto   title = TitleOf(volumes);
    WritePng(DrawTransferFunction(gray, drawn.values, drawn.lines, title, {}, shape.quantity, &renderer), pictureFile);
  }
  if (commandLine.IsGiven("report"))
  {
    WriteReport(commandLine, volumes, transferFunction, drawn, renderer);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, MakeTransferFunction);
}
