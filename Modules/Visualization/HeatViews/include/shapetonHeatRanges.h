#ifndef shapetonHeatRanges_h
#define shapetonHeatRanges_h

#include "ShapetonHeatViewsExport.h"

#include "shapetonHeatAxis.h"
#include "shapetonHeatClasses.h"
#include "shapetonHeatHistogram.h"

#include <vector>

namespace shapeton
{
/** Nested heat ranges: successive zoom levels of a histogram (dissertation 7.2.1, hierarchical heat histogram). The
 * last one is displayed; the others show its position. \ingroup ShapetonHeatViews */
using HeatRanges = std::vector<HeatRange>;

/** Parses a list a, b, c, d, ...: a to b, within it c to d, and so on. Throws ParameterError (histogramRange) for an
 * odd number of ends, ends outside [0, 1] or in the wrong order, a range not inside the previous one, and a range
 * inside a single bin of HeatHistogram, which cannot be resolved. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT HeatRanges
HeatRangesOf(const std::vector<double> & ends);

/** Counts of one row in bins that overlap the range; all others are 0. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT HeatHistogram
RowInside(const HeatHistogram & histogram, std::size_t row, const HeatRange & range);

/** Lines inside the range, as FindHeatClasses() finds them in isolation: a class of the whole volume may contain
 * several lines. Ascending and without gaps from the lower to the upper heat; labels count from 1. Of the measures,
 * only voxels and meanHeat are set. Empty if there are no counts. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT std::vector<HeatClass>
                         FindClassesInside(const HeatHistogram & histogram, std::size_t row, const HeatRange & range);
} // namespace shapeton

#endif
