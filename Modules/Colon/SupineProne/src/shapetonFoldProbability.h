#ifndef shapetonFoldProbability_h
#define shapetonFoldProbability_h

#include "shapetonColonPosition.h"

namespace shapeton
{
/** Fold probability of each pixel of the grid (row by row), 0 for wall, 1 for folds: the mean of two views. One is a
 * cubic step of curvature between its median and its 95th percentile, which also shows low folds and impressions of
 * other loops. The other one is the detected folds, drawn from end to end through their centers, all alike. */
std::vector<float>
FoldProbability(const ColonPosition & position);
} // namespace shapeton

#endif
