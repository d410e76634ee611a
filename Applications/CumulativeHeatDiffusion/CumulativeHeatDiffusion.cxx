#include "CumulativeHeatDiffusionXML.h"

#include "shapetonAutomaticParameters.h"
#include "shapetonCommandLine.h"
#include "shapetonReadOptions.h"
#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonHeatClassification.h"
#include "shapetonHeatParameterChoice.h"
#include "shapetonHeatResultFiles.h"
#include "shapetonHeatSnapshot.h"
#include "shapetonExceptions.h"
#include "shapetonToolDevice.h"
#include "shapetonToolVolumes.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>

namespace
{
using namespace shapeton;

using ImageType = itk::Image<float, 3>;
constexpr double shareOfChoice = 0.3; // of the time of a run
constexpr double endOfDiffusion = 0.95;
using FilterType = CumulativeHeatDiffusionImageFilter<ImageType>;

void
CheckUsage(const CommandLine & commandLine)
{
  RequireIntensityWindow(commandLine);
  RequireParameter(commandLine.IsGiven("snapshotSteps") || !commandLine.IsGiven("snapshotFolder"),
                   "--snapshotFolder requires --snapshotSteps, the steps to write");
  RequireParameter(!commandLine.IsGiven("snapshotSteps") || commandLine.IsGiven("snapshotFolder") ||
                     commandLine.IsGiven("report"),
                   "--snapshotSteps requires --snapshotFolder or --report, to store the heat");
}

/** Sets the parameters that are not given, unless the preset is the published one; returns the choice, if any. */
std::optional<HeatParameterChoice>
ChooseParameters(CommandLine & commandLine, FilterType * filter)
{
  if (commandLine.GetString("preset") == "published")
  {
    return {};
  }
  auto       options = filter->GetOptions();
  const auto given = GivenAmong(ReadGivenOptions(commandLine, options), options);
  const auto progress = commandLine.PartOfProgress(0.0, shareOfChoice).Part("Choosing parameters", 0.0, 1.0);
  const auto choice = ChooseHeatParameters(filter->GetVolume(), options, given, progress);
  filter->UseParameters(choice);
  for (const auto & [name, value] : ChosenValues(choice))
  {
    commandLine.AddProvenance("chosen." + name, value);
  }
  return choice;
}

void
RequestHistogram(const CommandLine & commandLine, FilterType * filter)
{
  const auto spacing =
    commandLine.GetString("snapshotSpacing") == "linear" ? SnapshotSpacing::Linear : SnapshotSpacing::Logarithmic;
  filter->SetHistogramSteps(MakeSnapshotSteps(filter->GetTimeSteps(), commandLine.GetInteger("snapshots"), spacing));
}

/** Schedules writing the heat after --snapshotSteps, or keeping it for the report; returns the steps. */
std::vector<std::uint64_t>
RequestSnapshots(CommandLine & commandLine, const HeatResultFiles & files, FilterType * filter)
{
  const auto          given = commandLine.GetIntegers("snapshotSteps");
  const std::set<int> distinct(given.begin(), given.end());
  for (const int step : distinct)
  {
    RequireParameter(step >= 0 && static_cast<std::uint64_t>(step) <= filter->GetTimeSteps(),
                     "--snapshotSteps: " + std::to_string(step) + " is not between 0 and the number of steps, " +
                       std::to_string(filter->GetTimeSteps()));
  }
  const std::vector<std::uint64_t> steps(distinct.begin(), distinct.end());
  if (!steps.empty())
  {
    const std::string     folder = commandLine.MakeFolderOf("snapshotFolder");
    std::set<std::string> names;
    std::transform(steps.begin(), steps.end(), std::inserter(names, names.end()), HeatSnapshotName);
    CommandLine::RequireNoOthers(folder, "heat-", names);
    filter->SetSnapshotSteps(
      steps, [&files, folder](std::uint64_t step, const ImageType * heat) { files.WriteSnapshot(heat, step, folder); });
  }
  return steps;
}

void
Diffuse(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const HeatResultFiles files(commandLine);
  auto                  filter = FilterType::New();
  ReadOptionsOf(commandLine, filter.GetPointer());
  CheckOptions(filter->GetOptions());
  const Volume volume = ReadVolume(commandLine, "inputVolume");
  filter->SetInput(volume.image);
  filter->SetDomain(ReadDomain(commandLine, volume.image));
  const auto choice = ChooseParameters(commandLine, filter);
  filter->SetWantInitialHeat(files.WantInitialHeat());
  filter->SetWantComponents(files.WantClasses());
  if (files.WantHistogram())
  {
    RequestHistogram(commandLine, filter);
  }
  const auto   snapshotSteps = RequestSnapshots(commandLine, files, filter);
  const double start = choice ? shareOfChoice : 0.0;
  commandLine.Watch(filter, "Diffusing heat", start, endOfDiffusion - start);
  filter->Update();
  const auto & result = filter->GetResult();
  commandLine.AddRunFact("device", result.device);
  const auto lastSnapshot = snapshotSteps.empty() ? 0 : snapshotSteps.back();
  commandLine.Warn(RemarksOnWindow(filter->GetVolume(), { { filter->GetWindowLower(), filter->GetWindowUpper() } }));
  commandLine.Warn(RunRemarks(result, filter->GetUntilSteady(), lastSnapshot));
  HeatClassification classification;
  if (files.WantClasses())
  {
    classification = ClassifyHeat(filter->GetOutput(), result);
  }
  HeatReportContent content = MakeReportContent(result, volume.image, filter->GetOutput());
  if (choice)
  {
    const auto reasons = ChoiceFacts(*choice);
    content.parameters.insert(content.parameters.end(), reasons.begin(), reasons.end());
  }
  content.input = { { "Modality", volume.modality }, { "Identity", volume.identity } };
  content.provenance = commandLine.GetProvenance();
  content.warnings = commandLine.GetWarnings();
  content.scale = commandLine.GetString("histogramScale") == "equalized" ? HeatScale::Equalized : HeatScale::Normalized;
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
