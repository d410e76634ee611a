#ifndef shapetonParticleResultFiles_h
#define shapetonParticleResultFiles_h

#include "ShapetonHeatToolsExport.h"
#include "shapetonHeatReport.h"
#include "shapetonParticleDiffusionImageFilter.h"
#include "shapetonParticlePreset.h"

#include <memory>
#include <string>
#include <vector>

namespace shapeton
{
class CommandLine;
class DicomOutput;
struct ShapeAnalysis;
struct Volume;

/** Warnings on a run of shapeton diffusion: trapped shapetons, density that did not reach the requested steady state,
 * few visits. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT std::vector<std::string>
                         ParticleRemarks(const ParticleDiffusionImageFilter<itk::Image<float, 3>> * filter);

/** A warning if the classes of a density do not show objects: there is one class only, or fewer than two are regions
 * besides the surroundings and the others are speckle; otherwise empty. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT std::vector<std::string>
                         PartRemarks(const std::vector<HeatClass> & classes);

/** Parameters and measures of a run as text, with the reasons for the choice. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT HeatReportContent::Facts
                         ParticleFacts(const ParticleDiffusionImageFilter<itk::Image<float, 3>> * filter,
                                       const ShapetonParameterChoice &                            choice);

/** The options that depend on the preset, by their names, as the last run used them. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT HeatReportContent::Facts
                         ShapetonValues(const ParticleDiffusionImageFilter<itk::Image<float, 3>> * filter);

/** \class ParticleResultFiles
 * \brief The output files of the shapeton diffusion tool, declared by the parameters of its XML.
 *
 * outputDensity and labels are volumes, classTable a CSV, report a folder that also contains a HeatExplorer;
 * histogramRange zooms in on ranges of its histogram. Outputs that were not requested are not written, except the
 * record of the run (`<outputDensity>.run.json`). The density contains visits and states its time step (key `timeStep`)
 * and provenance.
 *
 * \ingroup ShapetonHeatTools
 */
class ShapetonHeatTools_EXPORT ParticleResultFiles
{
public:
  using FilterType = ParticleDiffusionImageFilter<itk::Image<float, 3>>;

  /** Registers the outputs. Throws ParameterError for an unsupported volume extension or wrong ranges, OutputError if a
   * file cannot be written. */
  explicit ParticleResultFiles(CommandLine & commandLine);
  ~ParticleResultFiles();

  /** Whether the histogram is needed. */
  bool
  WantHistogram() const
  {
    return !m_Report.empty();
  }

  void
  Write(const FilterType * filter, const ShapetonParameterChoice & choice, const Volume & volume) const;

  /** Writes only the density, or the labels if they were requested; Write() does both. */
  ///@{
  void
  WriteDensity(const itk::Image<std::uint32_t, 3> * visits, std::uint64_t timeStep) const;
  void
  WriteLabels(const ShapeAnalysis & shape) const;
  ///@}

private:
  CommandLine &                      m_CommandLine;
  std::string                        m_Density;
  std::string                        m_Labels;
  std::string                        m_ClassTable;
  std::string                        m_Report;
  HeatRanges                         m_Ranges;
  std::shared_ptr<const DicomOutput> m_DicomMap;

  std::unique_ptr<HeatExplorer> m_Explorer; // null without a report
};
} // namespace shapeton

#endif
