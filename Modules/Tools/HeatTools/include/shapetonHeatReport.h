#ifndef shapetonHeatReport_h
#define shapetonHeatReport_h

#include "ShapetonHeatToolsExport.h"

#include "shapetonRemarks.h"
#include "shapetonCsvTable.h"
#include "shapetonCumulativeHeatDiffusion.h"
#include "shapetonHeatClasses.h"
#include "shapetonHeatExplorer.h"
#include "shapetonHeatHistogram.h"
#include "shapetonHeatParameterChoice.h"
#include "shapetonOutputPath.h"
#include "shapetonObjectColors.h"
#include "itkImage.h"
#include "shapetonShapeQuantity.h"
#include "shapetonShapeTransferFunction.h"
#include "shapetonVolumeRendering.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** Content of a diffusion report, for heat or shapetons. With `ranges`, a second histogram shows the last one, and a
 * second rendering the lines in it; `lines` and `objects` are not used.
 * \ingroup ShapetonHeatTools */
struct HeatReportContent : public HeatExplorerContent
{
  using Facts = std::vector<std::pair<std::string, std::string>>;

  HeatReportContent() { title = "Cumulative heat diffusion"; }

  /** Input, for example its name, modality, repairs. The geometry of `gray` is added. */
  Facts input;
  /** Parameters of the run, with the source of automatic values. */
  Facts   parameters;
  Facts   provenance;
  Remarks warnings;
  /** Time steps marked in the histogram. */
  std::vector<std::uint64_t> markedTimeSteps;
  /** The quantity, on the grid of `gray`. */
  const itk::Image<float, 3> * heat{ nullptr };
  /** The time step of `heat`, if known. */
  std::optional<std::uint64_t> timeStep;
  /** The classes of `heat`. */
  std::vector<HeatClass> classes;
  /** Transfer function of the rendering; by default ShapeTransferFunction::FromClasses. */
  std::optional<ShapeTransferFunction> transferFunction;
  /** What the rendering shows instead of `heat` with `transferFunction`: classes of lines and objects. */
  std::optional<ColoredClasses> drawn;
  /** Optional renderer; it must use the same heat and transfer function, or `drawn`. */
  const VolumeRenderer * renderer{ nullptr };
  /** Whether WriteExplorer() writes its page to the same folder; the report links to it. */
  bool hasExplorer{ false };
};

/** Writes a report into an existing folder: index.html (self-contained), histogram.png, slices-heat.png (named after
 * the quantity), slices-classes.png, rendering.png, classes.csv and report.json; with zoomed ranges also
 * histogram-range.png and rendering-range.png. Equal content gives equal bytes. Throws OutputError, and
 * std::invalid_argument for incomplete content. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT void
WriteHeatReport(const HeatReportContent & content, const std::string & folder, const OutputPath & outputPath);

/** Writes the page explorer.html for the report. The time step of the report is added as the last one if missing.
 * Throws OutputError. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT void
WriteExplorer(const HeatReportContent & content, HeatExplorer & explorer);

/** The classes as a table: label, lowerHeat, upperHeat, meanHeat, voxels, volume (mm^3), borderShare, components,
 * normalizedHeat, coherence (empty if not measured), and the color in pictures ("#rrggbb"; empty for the background).
 * For visits, Density replaces Heat, and meanVisits replaces components and normalizedHeat. \ingroup ShapetonHeatTools
 */
ShapetonHeatTools_EXPORT CsvTable
ClassTable(const std::vector<HeatClass> & classes, const ShapeQuantity & quantity = {});

/** The class table of the report. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT CsvTable
ClassTable(const HeatReportContent & content);

/** The histogram of the report, with its marks and classes. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT Picture::Pointer
                         DrawHistogram(const HeatReportContent & content);

/** The histogram of content.ranges, with the lines found inside the last range instead of the classes.
 * \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT Picture::Pointer
                         DrawOpenedHistogram(const HeatReportContent & content);

/** A warning if the last of content.ranges has no counts; otherwise empty, also if there are no ranges.
 * \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT Remarks
RangeRemarks(const HeatReportContent & content);

/** Nonzero counts of a heat histogram, in 32 ranges per factor of two of the heat: timeStep, lowerHeat, upperHeat,
 * voxels. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT CsvTable
HistogramTable(const HeatHistogram & histogram, const ShapeQuantity & quantity = {});

/** Parameters of a run as text, with the reason for each value chosen from the data.
 * \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT HeatReportContent::Facts
                         RunFacts(const CumulativeHeatDiffusionResult & result);

/** The reasons for chosen parameters, for HeatReportContent::parameters. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT HeatReportContent::Facts
                         ChoiceFacts(const HeatParameterChoice & choice);

/** The parameters of a choice, by the names of options, for the provenance. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT HeatReportContent::Facts
                         ChosenValues(const HeatParameterChoice & choice);

/** A report on a run with its parameters, histogram, images and time step; the arguments must outlive it.
 * \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT HeatReportContent
MakeReportContent(const CumulativeHeatDiffusionResult & result,
                  const itk::Image<float, 3> *          gray,
                  const itk::Image<float, 3> *          heat);

/** Warnings on a run: a constant volume, fewer than three coherent classes, heat that did not reach the requested
 * steady state, snapshots up to `lastSnapshotStep` skipped because the steady state came first.
 * \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT std::vector<std::string>
RunRemarks(const CumulativeHeatDiffusionResult & result, bool untilSteady, std::uint64_t lastSnapshotStep);
} // namespace shapeton

#endif
