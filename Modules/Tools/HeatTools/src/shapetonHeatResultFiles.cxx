#include "shapetonHeatResultFiles.h"

#include "shapetonCommandLine.h"
#include "shapetonCsvTable.h"
#include "shapetonDicomOutput.h"
#include "shapetonHeatSnapshot.h"
#include "shapetonLabelFiles.h"
#include "shapetonOpenedRanges.h"
#include "shapetonReportFolder.h"
#include "shapetonVolumeOutput.h"

namespace shapeton
{
HeatResultFiles::HeatResultFiles(CommandLine & commandLine)
  : m_CommandLine(commandLine)
  , m_Heat(VolumeOutput(commandLine, "outputHeat"))
  , m_InitialHeat(VolumeOutput(commandLine, "initialHeatOutput"))
  , m_Labels(VolumeOutput(commandLine, "labels"))
  , m_ClassTable(commandLine.OutputOf("classTable"))
  , m_Histogram(commandLine.OutputOf("histogram"))
  , m_HistogramTable(commandLine.OutputOf("histogramTable"))
  , m_Report(commandLine.GetString("report"))
  , m_Ranges(ReadOpenedRanges(commandLine))
  , m_DicomMap(std::make_shared<DicomOutput>(commandLine, "dicomMap"))
{
  commandLine.RecordRun(commandLine.GetString("outputHeat") + ".run.json");
  if (!m_Report.empty())
  {
    m_Explorer = MakeExplorer(commandLine, m_Report);
  }
}

HeatResultFiles::~HeatResultFiles() = default;

void
HeatResultFiles::Write(HeatReportContent content, const itk::Image<unsigned char, 3> * labels) const
{
  OpenRanges(m_CommandLine, m_Ranges, content);
  this->WriteHeat(content.heat, content.timeStep.value_or(0), m_Heat);
  m_DicomMap->WriteMap(content.heat, "HEAT", "Cumulative heat");
  if (!m_Labels.empty())
  {
    WriteClassLabels(labels, content.classes, content.quantity, m_Labels, m_CommandLine.GetProvenance());
  }
  if (!m_ClassTable.empty())
  {
    shapeton::ClassTable(content).Write(m_ClassTable);
  }
  if (!m_Histogram.empty())
  {
    WritePng(m_Ranges.empty() ? DrawHistogram(content) : DrawOpenedHistogram(content), m_Histogram);
  }
  if (!m_HistogramTable.empty())
  {
    shapeton::HistogramTable(*content.histogram).Write(m_HistogramTable);
  }
  if (!m_Report.empty())
  {
    content.hasExplorer = true;
    WriteExplorer(content, *m_Explorer);
    WriteHeatReport(content, m_Report, [this](const std::string & path) { return m_CommandLine.Output(path); });
  }
}

void
HeatResultFiles::WriteInitialHeat(const itk::Image<float, 3> * heat) const
{
  this->WriteHeat(heat, 0, m_InitialHeat);
}

void
HeatResultFiles::WriteSnapshot(const itk::Image<float, 3> * heat,
                               std::uint64_t                timeStep,
                               const std::string &          folder) const
{
  if (!folder.empty())
  {
    this->WriteHeat(heat, timeStep, m_CommandLine.Output(folder + '/' + HeatSnapshotName(timeStep)));
  }
  if (m_Explorer)
  {
    m_Explorer->AddStep(heat, timeStep);
  }
}

void
HeatResultFiles::WriteHeat(const itk::Image<float, 3> * heat, std::uint64_t timeStep, const std::string & path) const
{
  auto metadata = ProvenanceMetadata(m_CommandLine.GetProvenance());
  metadata.emplace_back("timeStep", std::to_string(timeStep));
  WriteVolume(heat, path, metadata);
}
} // namespace shapeton
