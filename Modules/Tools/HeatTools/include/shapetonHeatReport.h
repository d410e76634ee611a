#ifndef shapetonHeatReport_h
#define shapetonHeatReport_h

#include "HeatToolsExport.h"

#include "shapetonRemarks.h"
#include "shapetonCsvTable.h"
#include "shapetonCumulativeHeatDiffusion.h"
#include "shapetonHeatClasses.h"
#include "shapetonHeatExplorer.h"
#include "shapetonHeatHistogram.h"
#include "shapetonHeatRanges.h"
#include "shapetonHtmlReport.h"
#include "itkImage.h"
#include "shapetonShapeQuantity.h"
#include "shapetonShapeTransferFunction.h"
#include "shapetonVolumeRendering.h"
#include "shapetonSliceMontage.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** What a report on diffusion tells, of heat or of shapetons. The pointers are not owned and must not be null.
 * \ingroup HeatTools */
struct HeatReportContent
{
  using Facts = std::vector<std::pair<std::string, std::string>>;

  std::string title{ "Cumulative heat diffusion" };
  /** What `heat` holds. */
  ShapeQuantity quantity;
  /** What was analysed, for example its name, modality, repairs. The geometry of `grey` is added. */
  Facts input;
  /** The parameters of the run, and where automatic ones come from. */
  Facts   parameters;
  Facts   provenance;
  Remarks warnings;

  const HeatHistogram * histogram{ nullptr };
  /** Lays out axis and colours in its place, where given. */
  const HeatHistogram * axisHistogram{ nullptr };
  HeatScale             scale{ HeatScale::Equalized };
  /** Ranges that are opened; by default none. A second histogram shows the last one, a second rendering the lines that
   * are found in it, and the explorer begins there. */
  HeatRanges ranges;
  /** Marked in the histogram. */
  std::vector<std::uint64_t> markedTimeSteps;

  /** The intensity image and the heat, on one grid. */
  const itk::Image<float, 3> * grey{ nullptr };
  const itk::Image<float, 3> * heat{ nullptr };
  /** The time step that `heat` shows, where that is known. */
  std::optional<std::uint64_t> timeStep;
  /** Grey values of the slices. */
  IntensityWindow window;

  /** The classes of `heat`. */
  std::vector<HeatClass> classes;
  /** What the rendering shows; by default ShapeTransferFunction::FromClasses. */
  std::optional<ShapeTransferFunction> transferFunction;
  /** Draws the rendering, where given; it must be of the same heat and transfer function. */
  const VolumeRenderer * renderer{ nullptr };
  /** The page that WriteExplorer() writes stands beside the report, which links to it. */
  bool hasExplorer{ false };
};

/** Writes a report into an existing folder: index.html (self-contained), histogram.png, slices-heat.png
 * (named by the quantity),
 * slices-classes.png, rendering.png, classes.csv and report.json; of opened ranges also histogram-range.png and
 * rendering-range.png. Equal content gives equal bytes. Throws OutputError,
 * and std::invalid_argument for incomplete content. \ingroup HeatTools */
HeatTools_EXPORT void
WriteHeatReport(const HeatReportContent & content, const std::string & folder, const OutputPath & outputPath);

/** Writes the page explorer.html of what the report shows; the time step of the report is added as the last one where
 * it is not there. Throws OutputError. \ingroup HeatTools */
HeatTools_EXPORT void
WriteExplorer(const HeatReportContent & content, HeatExplorer & explorer);

/** The classes as a table: label, lowerHeat, upperHeat, meanHeat, voxels, volume (mm^3), borderShare, components,
 * normalizedHeat, and the colour in pictures ("#rrggbb"; empty for the background). For visits, Density in place of
 * Heat, and meanVisits in place of components and normalizedHeat. \ingroup HeatTools */
HeatTools_EXPORT CsvTable
ClassTable(const std::vector<HeatClass> & classes, const HeatAxis & axis, const ShapeQuantity & quantity = {});

/** The class table of the report. \ingroup HeatTools */
HeatTools_EXPORT CsvTable
ClassTable(const HeatReportContent & content);

/** The histogram of the report, with its marks and classes. \ingroup HeatTools */
HeatTools_EXPORT Picture::Pointer
                 DrawHistogram(const HeatReportContent & content);

/** The same of content.ranges, with the lines that are found inside the last one in place of the classes.
 * \ingroup HeatTools */
HeatTools_EXPORT Picture::Pointer
                 DrawOpenedHistogram(const HeatReportContent & content);

/** Says that nothing was ever counted in the last of content.ranges; empty where something was, or nothing is opened.
 * \ingroup HeatTools */
HeatTools_EXPORT Remarks
RangeRemarks(const HeatReportContent & content);

/** The counts of a heat histogram that are not 0, in 32 ranges for each factor of two of the heat: timeStep, lowerHeat,
 * upperHeat, voxels. \ingroup HeatTools */
HeatTools_EXPORT CsvTable
HistogramTable(const HeatHistogram & histogram, const ShapeQuantity & quantity = {});

/** The parameters of a run in words, with the reason where a parameter was chosen from the data.
 * \ingroup HeatTools */
HeatTools_EXPORT HeatReportContent::Facts
                 RunFacts(const CumulativeHeatDiffusionResult & result);

/** A report on a run with its parameters, histogram, images and time step; the arguments must outlive it.
 * \ingroup HeatTools */
HeatTools_EXPORT HeatReportContent
MakeReportContent(const CumulativeHeatDiffusionResult & result,
                  const itk::Image<float, 3> *          grey,
                  const itk::Image<float, 3> *          heat);

/** What the user of a run should know: a constant volume, a heat that is not steady although that was asked for,
 * snapshots up to `lastSnapshotStep` that the steady state cut off. \ingroup HeatTools */
HeatTools_EXPORT std::vector<std::string>
RunRemarks(const CumulativeHeatDiffusionResult & result, bool untilSteady, std::uint64_t lastSnapshotStep);
} // namespace shapeton

#endif
