#ifndef shapetonHeatHistogramPicture_h
#define shapetonHeatHistogramPicture_h

#include "HeatViewsExport.h"

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
/** What a picture of a heat histogram shows.
 * \ingroup HeatViews */
struct HeatHistogramPictureOptions
{
  std::string   title{ "Heat histogram" };
  ShapeQuantity quantity;
  HeatScale     scale{ HeatScale::Equalized };
  /** The histogram that lays out the axis and its colours; by default the one that is drawn. */
  const HeatHistogram * axisHistogram{ nullptr };
  /** Only the last of these heats, equalised anew inside it, and above the plot how it opens from all heats; by default
   * all. */
  HeatRanges ranges;
  /** Time steps marked by pink lines (Figure 2.4); those outside the recorded ones are left out. */
  std::vector<std::uint64_t> markedTimeSteps;
  /** Classes marked below the plot by their ranges, numbers and colours. */
  std::vector<HeatClass> classes;
  /** Pixels; at least 600 x 400. */
  unsigned int width{ 1200 };
  unsigned int height{ 900 };
};

/** The pixels of a picture that hold counts.
 * \ingroup HeatViews */
struct PlotArea
{
  int left{ 0 };
  int top{ 0 };
  int width{ 0 };
  int height{ 0 };
};

/** Where DrawHeatHistogram() plots: the heat at axis position p lies in the column left + p * (width - 1), rounded; row
 * r of n rows lies from top + r * height / n. \ingroup HeatViews */
HeatViews_EXPORT PlotArea
PlotAreaOf(const HeatHistogramPictureOptions & options);

/** Draws a heat histogram as in the dissertation's Figures 2.3 to 2.7: time runs downwards, heat to the right. The
 * colour of a point tells its heat (HeatAxis::ColorOf), its brightness the logarithm of the number of voxels, raised
 * where a row has more than nearby, so that lines stand out; the white line at the left border is the background, bin
 * 0. Rows are drawn one below the other with equal heights, and the time axis is labelled with their time steps,
 * whether they are spaced linearly or not. The heat axis is labelled with heats on both scales.
 *
 * A range that was opened fills the plot. Above it is a strip for each level, at most the last six: the axis of that
 * level, with the colours that its pictures have, and lines from the heats that the next one shows.
 *
 * Drawn on the CPU; equal input gives equal bytes. Throws std::invalid_argument for a histogram without rows and for
 * a picture that is too small.
 * \ingroup HeatViews */
HeatViews_EXPORT Picture::Pointer
                 DrawHeatHistogram(const HeatHistogram & histogram, const HeatHistogramPictureOptions & options = {});
} // namespace shapeton

#endif
