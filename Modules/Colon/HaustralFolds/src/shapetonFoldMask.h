#ifndef shapetonFoldMask_h
#define shapetonFoldMask_h

#include "shapetonCurvatureMixture.h"

namespace shapeton
{
/** 1 for the pixels of folds, by the least cut of a graph in which each pixel has four neighbours, those of the first
 * and last row each other. */
std::vector<char>
CutFolds(const FoldPicture & picture, const CurvatureMixture & mixture, const HaustralFoldOptions & options);

/** 1 where the curvature lies in the published interval. */
std::vector<char>
ThresholdFolds(const FoldPicture & picture, const HaustralFoldOptions & options);
} // namespace shapeton

#endif
