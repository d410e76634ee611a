#ifndef shapetonHeatRanges_h
#define shapetonHeatRanges_h

#include "HeatViewsExport.h"

#include "shapetonHeatAxis.h"
#include "shapetonHeatClasses.h"
#include "shapetonHeatHistogram.h"

#include <vector>

namespace shapeton
{
/** Ranges of heats, each within the one before: a histogram that opens up, level by level (dissertation 7.2.1,
 * hierarchical heat histogram). The last one is looked at; the others tell where it lies. \ingroup HeatViews */
using HeatRanges = std::vector<HeatRange>;

/** The ranges of a list a, b, c, d, ...: a to b, within it c to d, and so on. Throws ParameterError (histogramRange)
 * for ends without a partner, outside [0, 1] or in the wrong order, for a range that is not within the one before, and
 * for one that lies in a single bin of HeatHistogram, in which nothing can be told apart. \ingroup HeatViews */
HeatViews_EXPORT HeatRanges
HeatRangesOf(const std::vector<double> & ends);

/** The counts of one row whose bins lie in the range, at least in part; all others are 0. \ingroup HeatViews */
HeatViews_EXPORT HeatHistogram
RowInside(const HeatHistogram & histogram, std::size_t row, const HeatRange & range);

/** The lines inside the range, as FindHeatClasses() finds them where there is nothing else: a class of the whole volume
 * may hold many. Ascending and without gaps from the lower to the upper heat; labels count from 1. Of the measures
 * voxels and meanHeat are filled in. None where nothing was counted. \ingroup HeatViews */
HeatViews_EXPORT std::vector<HeatClass>
                 FindClassesInside(const HeatHistogram & histogram, std::size_t row, const HeatRange & range);
} // namespace shapeton

#endif
