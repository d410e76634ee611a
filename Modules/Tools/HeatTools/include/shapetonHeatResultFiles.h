#ifndef shapetonHeatResultFiles_h
#define shapetonHeatResultFiles_h

#include "ShapetonHeatToolsExport.h"

#include "shapetonHeatReport.h"
#include "shapetonVolumeWriter.h"
#include "itkImage.h"

#include <cstdint>
#include <memory>
#include <string>

namespace shapeton
{
class CommandLine;
class DicomOutput;

/** \class HeatResultFiles
 * \brief The output files of a heat diffusion tool, declared by the parameters of its XML.
 *
 * outputHeat, initialHeatOutput and labels are volumes, classTable and histogramTable CSV, histogram a PNG, report a
 * folder that also contains a HeatExplorer. histogramRange zooms in on ranges of the histogram and the report. Outputs
 * that were not requested are not written, except the record of the run (`<outputHeat>.run.json`). Volumes carry the
 * provenance of the run, heat also its time step (key `timeStep`).
 *
 * \ingroup ShapetonHeatTools
 */
class ShapetonHeatTools_EXPORT HeatResultFiles
{
public:
  /** Registers the outputs. Throws ParameterError for an unsupported volume extension or wrong ranges, OutputError if a
   * file cannot be written. */
  explicit HeatResultFiles(CommandLine & commandLine);
  ~HeatResultFiles();

  bool
  WantInitialHeat() const
  {
    return !m_InitialHeat.empty();
  }
  bool
  WantHistogram() const
  {
    return !m_Histogram.empty() || !m_HistogramTable.empty() || !m_Report.empty();
  }
  bool
  WantClasses() const
  {
    return !m_Labels.empty() || !m_ClassTable.empty() || !m_Report.empty();
  }

  /** Writes all files except the initial heat: content.heat is the heat after content.timeStep; `labels` may be null if
   * no classes are requested. The ranges of the content must be those of the parameter histogramRange. */
  void
  Write(HeatReportContent content, const itk::Image<unsigned char, 3> * labels) const;

  void
  WriteInitialHeat(const itk::Image<float, 3> * heat) const;

  /** Writes the heat after a time step into a folder of snapshots, see HeatSnapshotName(), and adds it to the explorer
   * of the report. Does nothing if the folder name is empty. */
  void
  WriteSnapshot(const itk::Image<float, 3> * heat, std::uint64_t timeStep, const std::string & folder) const;

private:
  void
  WriteHeat(const itk::Image<float, 3> * heat, std::uint64_t timeStep, const std::string & path) const;

  CommandLine &                      m_CommandLine;
  std::string                        m_Heat;
  std::string                        m_InitialHeat;
  std::string                        m_Labels;
  std::string                        m_ClassTable;
  std::string                        m_Histogram;
  std::string                        m_HistogramTable;
  std::string                        m_Report;
  HeatRanges                         m_Ranges;
  std::shared_ptr<const DicomOutput> m_DicomMap;

  std::unique_ptr<HeatExplorer> m_Explorer; // null without a report
};
} // namespace shapeton

#endif
