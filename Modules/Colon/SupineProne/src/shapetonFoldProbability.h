#ifndef shapetonFoldProbability_h
#define shapetonFoldProbability_h

#include "shapetonColonPosition.h"

namespace shapeton
{
/** 0 for the wall, 1 for folds, of each pixel of the grid (row by row): the mean of two views. One is a cubic step of
 * curvature between its median and the value that 95 % do not exceed, which sees low folds, and loops that press in;
 * the other one are the folds that were found, from end to end through their middles, all alike. */
std::vector<float>
FoldProbability(const ColonPosition & position);
} // namespace shapeton

#endif
