#include "CumulativeHeatDiffusionXML.h"

#include "shapetonAutomaticParameters.h"
#include "shapetonCommandLine.h"
#include "shapetonReadOptions.h"
#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonHeatClassification.h"
#include "shapetonHeatResultFiles.h"
#include "shapetonExceptions.h"
#include "shapetonToolDevice.h"
#include "shapetonToolVolumes.h"

#include <set>

namespace
{
using shapeton::CommandLine;
using ImageType = itk::Image<float, 3>;
using FilterType = shapeton::CumulativeHeatDiffusionImageFilter<ImageType>;

void
CheckUsage(const CommandLine & commandLine)
{
  shapeton::RequireIntensityWindow(commandLine);
  shapeton::RequireParameter(!commandLine.GetFlag("autoParameters") || !commandLine.IsGiven("p"),
                             "--autoParameters chooses p; do not combine it with --p");
  shapeton::RequireParameter(commandLine.IsGiven("snapshotSteps") || !commandLine.IsGiven("snapshotFolder"),
                             "--snapshotFolder requires --snapshotSteps, the steps to write");
  shapeton::RequireParameter(!commandLine.IsGiven("snapshotSteps") || commandLine.IsGiven("snapshotFolder") ||
                               commandLine.IsGiven("report"),
                             "--snapshotSteps requires --snapshotFolder or --report, to store the heat");
  for (const int step : commandLine.GetIntegers("snapshotSteps"))
  {
    shapeton::RequireParameter(step >= 0 && step <= commandLine.GetInteger("timeSteps"),
                               "--snapshotSteps: " + std::to_string(step) + " is not between 0 and --timeSteps");
  }
}

void
Configure(CommandLine & commandLine, FilterType * filter)
{
  shapeton::ReadOptionsOf(commandLine, filter);
  if (commandLine.GetFlag("autoParameters"))
  {
    filter->AutomaticPOn();
    filter->UntilSteadyOn();
    commandLine.AddProvenance("option.p", "automatic");
  }
}

void
RequestHistogram(const CommandLine & commandLine, FilterType * filter)
{
  const auto spacing = commandLine.GetString("snapshotSpacing") == "linear" ? shapeton::SnapshotSpacing::Linear
                                                                            : shapeton::SnapshotSpacing::Logarithmic;
  filter->SetHistogramSteps(
    shapeton::MakeSnapshotSteps(filter->GetTimeSteps(), commandLine.GetInteger("snapshots"), spacing));
}

/** Schedules writing the heat after --snapshotSteps, or keeping it for the report; returns the steps. */
std::vector<std::uint64_t>
RequestSnapshots(CommandLine & commandLine, const shapeton::HeatResultFiles & files, FilterType * filter)
{
  const auto                       given = commandLine.GetIntegers("snapshotSteps");
  const std::set<std::uint64_t>    distinct(given.begin(), given.end());
  const std::vector<std::uint64_t> steps(distinct.begin(), distinct.end());
  if (!steps.empty())
  {
    const std::string folder = commandLine.GetString("snapshotFolder");
    if (!folder.empty())
    {
      commandLine.MakeFolder(folder);
    }
    filter->SetSnapshotSteps(
      steps, [&files, folder](std::uint64_t step, const ImageType * heat) { files.WriteSnapshot(heat, step, folder); });
  }
  return steps;
}

void
Diffuse(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const shapeton::HeatResultFiles files(commandLine);
  const shapeton::Volume          volume = shapeton::ReadVolume(commandLine, "inputVolume");
  auto                            filter = FilterType::New();
  filter->SetInput(volume.image);
  Configure(commandLine, filter);
  filter->SetWantInitialHeat(files.WantInitialHeat());
  filter->SetWantComponents(files.WantClasses());
  if (files.WantHistogram())
  {
    RequestHistogram(commandLine, filter);
  }
  const auto snapshotSteps = RequestSnapshots(commandLine, files, filter);
  commandLine.Watch(filter, "Diffusing heat", 0.0, 0.95);
  filter->Update();
  const auto & result = filter->GetResult();
  commandLine.AddRunFact("device", result.device);
  const auto lastSnapshot = snapshotSteps.empty() ? 0 : snapshotSteps.back();
  for (const auto & remark : shapeton::RunRemarks(result, filter->GetUntilSteady(), lastSnapshot))
  {
    commandLine.Warn(remark);
  }
  if (filter->GetAutomaticP())
  {
    commandLine.AddProvenance("chosen.p", shapeton::CsvTable::Number(result.p.p));
  }
  shapeton::HeatClassification classification;
  if (files.WantClasses())
  {
    classification = shapeton::ClassifyHeat(filter->GetOutput(), result.components);
  }
  shapeton::HeatReportContent content = shapeton::MakeReportContent(result, volume.image, filter->GetOutput());
  content.input = { { "Modality", volume.modality }, { "Identity", volume.identity } };
  content.provenance = commandLine.GetProvenance();
  content.warnings = commandLine.GetWarnings();
  content.scale = commandLine.GetString("histogramScale") == "equalized" ? shapeton::HeatScale::Equalized
                                                                         : shapeton::HeatScale::Normalized;
  content.classes = classification.classes;
  content.markedTimeSteps = snapshotSteps;
  files.Write(content, classification.labels);
  if (files.WantInitialHeat())
  {
    files.WriteInitialHeat(filter->GetInitialHeatOutput());
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Diffuse);
}
