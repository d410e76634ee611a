#ifndef shapetonDistensionChart_h
#define shapetonDistensionChart_h

#include "shapetonColonPictures.h"
#include "shapetonPlotFrame.h"

namespace shapeton
{
/** Least calibre, mm, of a colon that is distended enough to be looked at. \ingroup ColonViews */
constexpr double distendedCalibre = 10.0;

/** Title and size of a DrawDistensionChart(). \ingroup ColonViews */
struct DistensionChartOptions
{
  std::string title{ "Distension" };
  /** Pixels; at least 500 x 300. */
  unsigned int width{ 1200 };
  unsigned int height{ 460 };
};

/** The calibre (twice the radius of the centreline, mm) by the distance from the anal verge, with a line at 10 mm, what
 * lies below it in a colour of its own, gaps shaded, and the segments' borders and names.
 *
 * Throws InputError where the centreline has no arrays arcLength and radius, std::invalid_argument for a picture too
 * small. \ingroup ColonViews */
ColonViews_EXPORT Picture::Pointer
                  DrawDistensionChart(const CurveSet &                  centreline,
                                      const std::vector<ColonSegment> & segments,
                                      const DistensionChartOptions &    options = {});

/** Where the values lie in that picture. \ingroup ColonViews */
ColonViews_EXPORT PlotFrame
DistensionFrame(const CurveSet & centreline, const DistensionChartOptions & options = {});
} // namespace shapeton

#endif
