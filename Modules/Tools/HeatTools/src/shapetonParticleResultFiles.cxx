#include "shapetonParticleResultFiles.h"

#include "shapetonAxisTicks.h"
#include "shapetonCommandLine.h"
#include "shapetonDicomOutput.h"
#include "shapetonLabelFiles.h"
#include "shapetonOpenedRanges.h"
#include "shapetonReportFolder.h"
#include "shapetonShapeAnalysis.h"
#include "shapetonVolumeOutput.h"
#include "shapetonVolume.h"
#include "shapetonVolumeWriter.h"

#include <algorithm>

namespace shapeton
{
namespace
{
using FilterType = ParticleResultFiles::FilterType;
using Facts = HeatReportContent::Facts;

double
LongestSide(const itk::Image<float, 3> * image)
{
  double side = 0.0;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    side =
      std::max(side, static_cast<double>(image->GetLargestPossibleRegion().GetSize(axis)) * image->GetSpacing()[axis]);
  }
  return side;
}

std::string
Percent(double share)
{
  return CsvTable::Rounded(100.0 * share, 4) + " %";
}

double
ShareTrapped(const FilterType * filter)
{
  return static_cast<double>(filter->GetMeasures().trappedShapetons) / filter->GetShapetons();
}

double
MeanVisits(const FilterType * filter)
{
  const ParticleMeasures & measures = filter->GetMeasures();
  return static_cast<double>(measures.step) * filter->GetShapetons() /
         static_cast<double>(std::max<std::uint64_t>(1, measures.voxelsReached));
}
} // namespace

std::vector<std::string>
ParticleRemarks(const FilterType * filter)
{
  const ParticleMeasures & measures = filter->GetMeasures();
  std::vector<std::string> remarks;
  AppendRemarks(
    remarks,
    RemarksOnWindow(VolumeView(filter->GetInput()), { { filter->GetWindowLower(), filter->GetWindowUpper() } }));
  if (filter->GetUntilSteady() && !measures.steady)
  {
    remarks.push_back("the density is not yet steady after " + std::to_string(measures.step) + " steps");
  }
  constexpr double manyTrapped = 0.05;
  if (ShareTrapped(filter) >= manyTrapped)
  {
    remarks.push_back(
      Percent(ShareTrapped(filter)) +
      " of the shapetons are trapped in voxels that are cut off from all six neighbors: choose a smaller "
      "p for a noisy volume");
  }
  if (MeanVisits(filter) < 4.0)
  {
    remarks.push_back("the voxels reached have " + CsvTable::Rounded(MeanVisits(filter), 3) +
                      " visits on average, which is hardly above noise: use more shapetons or steps");
  }
  return remarks;
}

std::vector<std::string>
PartRemarks(const std::vector<HeatClass> & classes)
{
  const auto isPart = [](const HeatClass & c) { return c.label > 0 && !c.isSurroundings && !IsIncoherent(c); };
  const auto parts = std::count_if(classes.begin(), classes.end(), isPart);
  if (classes.size() <= 2)
  {
    return { "all visited voxels are in one class of density: no objects can be distinguished" };
  }
  if (parts < 2 && std::any_of(classes.begin(), classes.end(), IsIncoherent))
  {
    return { "the density shows " + std::string(parts == 0 ? "no parts" : "one part") +
             " besides scattered voxels: CumulativeHeatDiffusion shows more of this volume" };
  }
  return {};
}

HeatReportContent::Facts
ParticleFacts(const FilterType * filter, const ShapetonParameterChoice & choice)
{
  const ParticleMeasures & measures = filter->GetMeasures();
  const double             millimeters = filter->GetDistance() * LongestSide(filter->GetInput());
  Facts                    facts = { { "Intensity window",
                                       CsvTable::Number(filter->GetWindowLower()) + " to " + CsvTable::Number(filter->GetWindowUpper()) },
                                     { "p", CsvTable::Rounded(filter->GetP(), 6) },
                                     { "Smoothing, mm", CsvTable::Rounded(filter->GetSmoothing(), 6) },
                                     { "Shapetons", GroupedDigits(filter->GetShapetons()) },
                                     { "Distance",
                                       CsvTable::Rounded(filter->GetDistance(), 6) + " of the longest side, " +
                                         CsvTable::Rounded(millimeters, 4) + " mm" },
                                     { "Time steps", GroupedDigits(measures.step) + (measures.steady ? ": the density is steady" : "") },
                                     { "Direction sampling", NameOf(filter->GetDirectionSampling()) },
                                     { "Path rule", NameOf(filter->GetPathRule()) },
                                     { "Placement", NameOf(filter->GetPlacement()) },
                                     { "Seed", std::to_string(filter->GetSeed()) },
                                     { "Visits", GroupedDigits(measures.step * filter->GetShapetons()) },
                                     { "Greatest number of visits", GroupedDigits(measures.maximumVisits) },
                                     { "Mean number of visits of the voxels reached", CsvTable::Rounded(MeanVisits(filter), 4) },
                                     { "Coverage: object voxels reached", Percent(measures.GetCoverage()) },
                                     { "Change in the last step (3.10)", CsvTable::Rounded(measures.change, 4) },
                                     { "Change of a steady state",
                                       CsvTable::Rounded(filter->GetEpsilon().value_or(measures.automaticEpsilon), 4) +
                                         (!filter->GetEpsilon() ? ": the voxels reached then have 100 visits on average" : "") },
                                     { "Shapetons trapped", Percent(ShareTrapped(filter)) } };
  const Facts              reasons = ChoiceFacts(choice.heat);
  facts.insert(facts.end(), reasons.begin(), reasons.end());
  if (!choice.feature.distanceReason.empty())
  {
    facts.emplace_back("Reason for the distance", choice.feature.distanceReason);
  }
  if (!choice.feature.shapetonsReason.empty())
  {
    facts.emplace_back("Reason for the number of shapetons", choice.feature.shapetonsReason);
  }
  return facts;
}

HeatReportContent::Facts
ShapetonValues(const FilterType * filter)
{
  return { { "intensityWindow",
             CsvTable::Number(filter->GetWindowLower()) + "," + CsvTable::Number(filter->GetWindowUpper()) },
           { "p", CsvTable::Number(filter->GetP()) },
           { "smoothing", CsvTable::Number(filter->GetSmoothing()) },
           { "timeSteps", std::to_string(filter->GetTimeSteps()) },
           { "shapetons", std::to_string(filter->GetShapetons()) },
           { "distance", CsvTable::Number(filter->GetDistance()) },
           { "directionSampling", NameOf(filter->GetDirectionSampling()) },
           { "pathRule", NameOf(filter->GetPathRule()) },
           { "placement", NameOf(filter->GetPlacement()) } };
}

ParticleResultFiles::ParticleResultFiles(CommandLine & commandLine)
  : m_CommandLine(commandLine)
  , m_Density(VolumeOutput(commandLine, "outputDensity"))
  , m_Labels(VolumeOutput(commandLine, "labels"))
  , m_ClassTable(commandLine.OutputOf("classTable"))
  , m_Report(commandLine.GetString("report"))
  , m_Ranges(ReadOpenedRanges(commandLine))
  , m_DicomMap(std::make_shared<DicomOutput>(commandLine, "dicomMap"))
{
  commandLine.RecordRun(commandLine.GetString("outputDensity") + ".run.json");
  if (!m_Report.empty())
  {
    m_Explorer = MakeExplorer(commandLine, m_Report);
  }
}

ParticleResultFiles::~ParticleResultFiles() = default;

void
ParticleResultFiles::WriteDensity(const itk::Image<std::uint32_t, 3> * visits, std::uint64_t timeStep) const
{
  auto metadata = ProvenanceMetadata(m_CommandLine.GetProvenance());
  metadata.emplace_back("timeStep", std::to_string(timeStep));
  WriteVolume(visits, m_Density, metadata);
}

void
ParticleResultFiles::WriteLabels(const ShapeAnalysis & shape) const
{
  if (!m_Labels.empty())
  {
    WriteClassLabels(shape.labels, shape.classes, shape.quantity, m_Labels, m_CommandLine.GetProvenance());
  }
}

void
ParticleResultFiles::Write(const FilterType *              filter,
                           const ShapetonParameterChoice & choice,
                           const Volume &                  volume) const
{
  this->WriteDensity(filter->GetOutput(), filter->GetMeasures().step);
  m_DicomMap->WriteMap(filter->GetOutput(), "VISITS", "Visits of shapetons");
  if (m_Labels.empty() && m_ClassTable.empty() && m_Report.empty())
  {
    return;
  }
  const ShapeAnalysis shape = AnalyzeVisits(filter->GetOutput(), filter->GetMeasures().step);
  m_CommandLine.Warn(PartRemarks(shape.classes));
  HeatReportContent content;
  content.title = "Shapeton diffusion";
  content.quantity = shape.quantity;
  content.input = { { "Modality", volume.modality }, { "Identity", volume.identity } };
  content.parameters = ParticleFacts(filter, choice);
  content.provenance = m_CommandLine.GetProvenance();
  content.warnings = m_CommandLine.GetWarnings();
  content.histogram = filter->GetHistogram().GetNumberOfRows() > 0 ? &filter->GetHistogram() : &shape.histogram;
  // The first rows are noisy, and missing in a resumed run.
  content.axisHistogram = &shape.axisHistogram;
  content.gray = volume.image;
  content.heat = shape.values;
  content.timeStep = filter->GetMeasures().step;
  content.classes = shape.classes;
  OpenRanges(m_CommandLine, m_Ranges, content);
  this->WriteLabels(shape);
  if (!m_ClassTable.empty())
  {
    shapeton::ClassTable(content).Write(m_ClassTable);
  }
  if (!m_Report.empty())
  {
    content.hasExplorer = true;
    WriteExplorer(content, *m_Explorer);
    WriteHeatReport(content, m_Report, [this](const std::string & path) { return m_CommandLine.Output(path); });
  }
}
} // namespace shapeton
