#ifndef shapetonFoldMask_h
#define shapetonFoldMask_h

#include "shapetonCurvatureMixture.h"

namespace shapeton
{
/** 1 for the pixels of folds, by the minimum cut of a graph with four neighbors per pixel, periodic in rows. */
std::vector<char>
CutFolds(const FoldPicture & picture, const CurvatureMixture & mixture, const HaustralFoldOptions & options);

/** 1 where the curvature is in the published interval. */
std::vector<char>
ThresholdFolds(const FoldPicture & picture, const HaustralFoldOptions & options);
} // namespace shapeton

#endif
