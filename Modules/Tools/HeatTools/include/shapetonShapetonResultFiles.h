#ifndef shapetonShapetonResultFiles_h
#define shapetonShapetonResultFiles_h

#include "HeatToolsExport.h"
#include "shapetonHeatReport.h"
#include "shapetonShapetonDiffusionImageFilter.h"

#include <memory>
#include <string>
#include <vector>

namespace shapeton
{
class CommandLine;
class DicomMapOutput;
struct Volume;

/** What the user of a run of shapeton diffusion should know: trapped shapetons, a density that is not steady although
 * that was asked for, few visits. \ingroup HeatTools */
HeatTools_EXPORT std::vector<std::string>
                 ShapetonRemarks(const ShapetonDiffusionImageFilter<itk::Image<float, 3>> * filter);

/** The parameters and measures of a run in words, with reasons where the distance and the number of shapetons were
 * chosen from the data. \ingroup HeatTools */
HeatTools_EXPORT HeatReportContent::Facts
                 ShapetonFacts(const ShapetonDiffusionImageFilter<itk::Image<float, 3>> * filter);

/** \class ShapetonResultFiles
 * \brief The files that the tool of shapeton diffusion writes, by the parameters of its XML.
 *
 * outputDensity and labels are volumes, classTable a CSV, report a folder, which gets a HeatExplorer, too;
 * histogramRange opens ranges of its histogram. Those that were not given are not written. A record of the run
 * (`<outputDensity>.run.json`) is. The density holds visits and states its time step (key `timeStep`) and provenance.
 *
 * \ingroup HeatTools
 */
class HeatTools_EXPORT ShapetonResultFiles
{
public:
  using FilterType = ShapetonDiffusionImageFilter<itk::Image<float, 3>>;

  /** Registers the outputs. Throws ParameterError for a volume whose extension cannot be written and for wrong ranges,
   * and OutputError where nothing can be written. */
  explicit ShapetonResultFiles(CommandLine & commandLine);
  ~ShapetonResultFiles();

  /** Whether the histogram is needed. */
  bool
  WantHistogram() const
  {
    return !m_Report.empty();
  }

  void
  Write(const FilterType * filter, const Volume & volume) const;

private:
  CommandLine &                         m_CommandLine;
  std::string                           m_Density;
  std::string                           m_Labels;
  std::string                           m_ClassTable;
  std::string                           m_Report;
  HeatRanges                            m_Ranges;
  std::shared_ptr<const DicomMapOutput> m_DicomMap;

  std::unique_ptr<HeatExplorer> m_Explorer; // null without a report
};
} // namespace shapeton

#endif
