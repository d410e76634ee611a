#ifndef shapetonDistensionChart_h
#define shapetonDistensionChart_h

#include "shapetonColonPictures.h"
#include "shapetonPlotFrame.h"

namespace shapeton
{
/** Title and size of the picture of DrawDistensionChart(). \ingroup ShapetonColonViews */
struct DistensionChartOptions
{
  std::string title{ "Distension" };
  /** Pixels; at least 500 x 300. */
  unsigned int width{ 1200 };
  unsigned int height{ 460 };
};

/** Draws the caliber (twice the radius of the centerline, mm) over the distance from the anal verge, with a line at 10
 * mm, smaller calibers in another color, shaded gaps, and the boundaries and names of segments. Distances are shown in
 * cm.
 *
 * Throws InputError if the centerline lacks the arrays arcLength or radius, std::invalid_argument if the picture is too
 * small. \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT Picture::Pointer
                          DrawDistensionChart(const CurveSet &                  centerline,
                                              const std::vector<ColonSegment> & segments,
                                              const DistensionChartOptions &    options = {});

/** Plot area and axes of the picture of DrawDistensionChart(). \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT PlotFrame
DistensionFrame(const CurveSet & centerline, const DistensionChartOptions & options = {});
} // namespace shapeton

#endif
