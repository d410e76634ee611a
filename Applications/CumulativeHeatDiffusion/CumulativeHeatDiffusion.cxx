#include "CumulativeHeatDiffusionXML.h"

#include "itkAutomaticParameters.h"
#include "itkCommandLine.h"
#include "itkCumulativeHeatDiffusionImageFilter.h"
#include "itkHeatClassification.h"
#include "itkHeatReport.h"
#include "itkHeatSnapshot.h"
#include "itkToolError.h"
#include "itkVolumeReader.h"
#include "itkVolumeWriter.h"

#include <set>

namespace
{
using itk::CommandLine;
using ImageType = itk::Image<float, 3>;
using FilterType = itk::CumulativeHeatDiffusionImageFilter<ImageType>;

void
Require(bool condition, const std::string & message)
{
  if (!condition)
  {
    throw itk::UsageError(message);
  }
}

void
CheckUsage(const CommandLine & commandLine)
{
  const auto window = commandLine.GetDoubles("intensityWindow");
  Require(window.empty() || (window.size() == 2 && window[0] < window[1]),
          "--intensityWindow needs two numbers, the lower one first, for example -160,240");
  Require(!commandLine.GetFlag("autoParameters") || !commandLine.IsGiven("p"),
          "--autoParameters chooses p; give either it or --p");
  Require(commandLine.IsGiven("snapshotSteps") == commandLine.IsGiven("snapshotFolder"),
          "--snapshotSteps and --snapshotFolder go together; give both");
  for (const int step : commandLine.GetIntegers("snapshotSteps"))
  {
    Require(step >= 0 && step <= commandLine.GetInteger("timeSteps"),
            "--snapshotSteps: " + std::to_string(step) + " does not lie between 0 and --timeSteps");
  }
  for (const std::string name : { "outputHeat", "initialHeatOutput", "labels" })
  {
    itk::RequireVolumeName(commandLine.GetString(name));
  }
}

void
Configure(CommandLine & commandLine, FilterType * filter)
{
  if (const auto window = commandLine.GetDoubles("intensityWindow"); !window.empty())
  {
    filter->SetIntensityWindow(window[0], window[1]);
  }
  const bool automatic = commandLine.GetFlag("autoParameters");
  const bool isExplicit = commandLine.GetString("solver") == "explicit";
  const bool asPublished = commandLine.GetString("conductance") == "published";
  filter->SetP(commandLine.GetDouble("p"));
  filter->SetAutomaticP(automatic);
  if (automatic)
  {
    commandLine.AddProvenance("option.p", "automatic");
  }
  filter->SetTimeSteps(commandLine.GetInteger("timeSteps"));
  filter->SetTimeStepLength(commandLine.GetDouble("timeStepLength"));
  filter->SetTolerance(commandLine.GetDouble("tolerance"));
  filter->SetUntilSteady(automatic || commandLine.GetFlag("untilSteady"));
  filter->SetIgnoreSpacing(commandLine.GetFlag("ignoreSpacing"));
  filter->SetMethod(isExplicit ? FilterType::Method::Explicit : FilterType::Method::Chebyshev);
  filter->SetConductance(asPublished ? FilterType::Conductance::Published : FilterType::Conductance::Physical);
}

void
WriteHeat(const CommandLine & commandLine, const ImageType * heat, std::uint64_t timeStep, const std::string & path)
{
  auto metadata = itk::ProvenanceMetadata(commandLine);
  metadata.emplace_back("timeStep", std::to_string(timeStep));
  itk::WriteVolume(heat, path, metadata);
}

/** Has the heat after --snapshotSteps written while the filter runs; returns the steps. */
std::vector<std::uint64_t>
RequestSnapshots(CommandLine & commandLine, FilterType * filter)
{
  const auto                       given = commandLine.GetIntegers("snapshotSteps");
  const std::set<std::uint64_t>    distinct(given.begin(), given.end());
  const std::vector<std::uint64_t> steps(distinct.begin(), distinct.end());
  if (!steps.empty())
  {
    const std::string folder = commandLine.GetString("snapshotFolder");
    commandLine.MakeFolder(folder);
    filter->SetSnapshotSteps(steps, [&commandLine, folder](std::uint64_t step, const ImageType * heat) {
      WriteHeat(commandLine, heat, step, commandLine.Output(folder + '/' + itk::HeatSnapshotName(step)));
    });
  }
  return steps;
}

itk::HeatReportContent
Describe(const CommandLine & commandLine, const itk::Volume & volume, const FilterType * filter)
{
  itk::HeatReportContent content;
  content.input = { { "Modality", volume.modality }, { "Identity", volume.identity } };
  content.parameters = itk::RunFacts(filter->GetResult());
  content.provenance = commandLine.GetProvenance();
  content.warnings = commandLine.GetWarnings();
  content.histogram = &filter->GetResult().histogram;
  content.scale =
    commandLine.GetString("histogramScale") == "equalized" ? itk::HeatScale::Equalized : itk::HeatScale::Normalized;
  content.grey = volume.image;
  content.heat = filter->GetOutput();
  content.timeStep = filter->GetResult().timeStep;
  return content;
}

void
Diffuse(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const std::string output = commandLine.GetString("outputHeat");
  const std::string heatFile = commandLine.Output(output);
  const std::string initialHeatFile = commandLine.OutputOf("initialHeatOutput");
  const std::string labelsFile = commandLine.OutputOf("labels");
  const std::string classFile = commandLine.OutputOf("classTable");
  const std::string pictureFile = commandLine.OutputOf("histogram");
  const std::string tableFile = commandLine.OutputOf("histogramTable");
  const bool        wantReport = commandLine.IsGiven("report");
  const bool        wantClasses = wantReport || !labelsFile.empty() || !classFile.empty();

  const itk::Volume volume = itk::ReadVolume(commandLine, "inputVolume");
  auto              filter = FilterType::New();
  filter->SetInput(volume.image);
  Configure(commandLine, filter);
  filter->SetWantInitialHeat(!initialHeatFile.empty());
  filter->SetWantComponents(wantClasses);
  if (wantReport || !pictureFile.empty() || !tableFile.empty())
  {
    const bool isLinear = commandLine.GetString("snapshotSpacing") == "linear";
    filter->SetHistogramSteps(
      itk::MakeSnapshotSteps(filter->GetTimeSteps(),
                             commandLine.GetInteger("snapshots"),
                             isLinear ? itk::SnapshotSpacing::Linear : itk::SnapshotSpacing::Logarithmic));
  }
  const auto snapshotSteps = RequestSnapshots(commandLine, filter);
  commandLine.Watch(filter, "Diffusing heat", 0.0, 0.95);
  filter->Update();
  const auto lastSnapshot = snapshotSteps.empty() ? 0 : snapshotSteps.back();
  for (const auto & remark : itk::RunRemarks(filter->GetResult(), filter->GetUntilSteady(), lastSnapshot))
  {
    commandLine.Warn(remark);
  }
  if (filter->GetAutomaticP())
  {
    commandLine.AddProvenance("chosen.p", itk::CsvTable::Number(filter->GetResult().p.p));
  }
  WriteHeat(commandLine, filter->GetOutput(), filter->GetResult().timeStep, heatFile);
  if (!initialHeatFile.empty())
  {
    WriteHeat(commandLine, filter->GetInitialHeatOutput(), 0, initialHeatFile);
  }
  itk::HeatReportContent content = Describe(commandLine, volume, filter);
  content.markedTimeSteps = snapshotSteps;
  if (wantClasses)
  {
    const auto classification = itk::ClassifyHeat(filter->GetOutput(), filter->GetResult().components);
    content.classes = classification.classes;
    if (!labelsFile.empty())
    {
      itk::WriteVolume(classification.labels.GetPointer(), labelsFile, itk::ProvenanceMetadata(commandLine));
    }
  }
  if (!classFile.empty())
  {
    itk::ClassTable(content).Write(classFile);
  }
  if (!pictureFile.empty())
  {
    itk::WritePng(itk::DrawHistogram(content), pictureFile);
  }
  if (!tableFile.empty())
  {
    itk::HistogramTable(*content.histogram).Write(tableFile);
  }
  if (wantReport)
  {
    commandLine.MakeFolder(commandLine.GetString("report"));
    itk::WriteHeatReport(
      content, commandLine.GetString("report"), [&](const std::string & path) { return commandLine.Output(path); });
  }
  commandLine.RecordRun(output + ".run.json");
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Diffuse);
}
