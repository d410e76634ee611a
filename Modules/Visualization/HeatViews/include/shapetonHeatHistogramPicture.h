#ifndef shapetonHeatHistogramPicture_h
#define shapetonHeatHistogramPicture_h

#include "ShapetonHeatViewsExport.h"

#include "shapetonHeatClasses.h"
#include "shapetonHeatHistogram.h"
#include "shapetonHeatRanges.h"
#include "shapetonPicture.h"
#include "shapetonShapeQuantity.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** Content of a picture of a heat histogram.
 * \ingroup ShapetonHeatViews */
struct HeatHistogramPictureOptions
{
  std::string   title{ "Heat histogram" };
  ShapeQuantity quantity;
  HeatScale     scale{ HeatScale::Equalized };
  /** Histogram that defines the axis and its colors; by default the drawn one. */
  const HeatHistogram * axisHistogram{ nullptr };
  /** If not empty, shows only the last of these ranges, equalized separately, with the zoom levels above the plot. By
   * default the whole axis. */
  HeatRanges ranges;
  /** Time steps marked by pink lines (Figure 2.4); those outside the recorded range are skipped. */
  std::vector<std::uint64_t> markedTimeSteps;
  /** Classes marked below the plot by their ranges, numbers and colors. */
  std::vector<HeatClass> classes;
  /** Pixels; at least 600 x 400. */
  unsigned int width{ 1200 };
  unsigned int height{ 900 };
};

/** Plot area of a picture, pixels.
 * \ingroup ShapetonHeatViews */
struct PlotArea
{
  int left{ 0 };
  int top{ 0 };
  int width{ 0 };
  int height{ 0 };
};

/** The plot area of DrawHeatHistogram(): the heat at axis position p is in column left + p * (width - 1), rounded; row
 * r of n rows starts at top + r * height / n. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT PlotArea
PlotAreaOf(const HeatHistogramPictureOptions & options);

/** Draws a heat histogram as in the dissertation's Figures 2.3 to 2.7: time runs downwards, heat to the right. The
 * color of a point encodes its heat (HeatAxis::ColorOf), its brightness the logarithm of the number of voxels. The
 * brightness is raised where a row has more voxels than its neighborhood, so lines stand out. The white line at the
 * left border is the background, bin 0. Rows have equal heights. The time axis is labeled with the time steps, for
 * linear and nonlinear spacing. The heat axis is labeled with heat values on both scales.
 *
 * A zoomed range fills the plot. Above it, each level (at most the last six) has a strip with its axis in the colors of
 * its pictures. Lines start at the ends of the range that the next level shows.
 *
 * Drawn on the CPU; identical input yields identical bytes. Throws std::invalid_argument for a histogram without rows
 * and for a picture that is too small.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT Picture::Pointer
DrawHeatHistogram(const HeatHistogram & histogram, const HeatHistogramPictureOptions & options = {});
} // namespace shapeton

#endif
