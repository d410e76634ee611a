#ifndef shapetonFoldMask_h
#define shapetonFoldMask_h

#include "shapetonCurvatureMixture.h"

namespace shapeton
{
/** Fold mask computed by the minimum cut of a 4-connected graph, periodic in rows. */
std::vector<char>
CutFolds(const FoldPicture & picture, const CurvatureMixture & mixture, const HaustralFoldOptions & options);

/** Mask of the pixels whose curvature is in the published interval. */
std::vector<char>
ThresholdFolds(const FoldPicture & picture, const HaustralFoldOptions & options);
} // namespace shapeton

#endif
