#ifndef shapetonFoldProbability_h
#define shapetonFoldProbability_h

#include "shapetonColonPosition.h"

namespace shapeton
{
/** Fold probability of each pixel of the grid in row-major order, from 0 (wall) to 1 (fold): the mean of two terms. The
 * first is a cubic step of curvature between its median and 95th percentile, which includes low folds and impressions
 * of other loops. The second is a drawing of the detected folds, from end to end through their centers, with a uniform
 * profile. */
std::vector<float>
FoldProbability(const ColonPosition & position);
} // namespace shapeton

#endif
