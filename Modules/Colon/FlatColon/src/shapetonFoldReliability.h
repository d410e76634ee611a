#ifndef shapetonFoldReliability_h
#define shapetonFoldReliability_h

#include "shapetonCurvatureMixture.h"
#include "shapetonFoldShape.h"

namespace shapeton
{
/** Sets the reliability of a fold: 2 * (mean fold probability of its pixels) - 1 or, for the published scheme, mean
 * curvature / far end of the interval. */
void
RateFold(const FoldPicture &         picture,
         const CurvatureMixture &    mixture,
         const HaustralFoldOptions & options,
         MeasuredFold &              measured);

/** Sets the reliability of fold ends: the reliability of the fold at the border or a taenia, decreasing to half of that
 * with distance as a Gaussian of 10 mm. */
void
RateEnds(const FlatColonGrid & grid, const CurveSet * taeniae, std::vector<MeasuredFold> & folds);
} // namespace shapeton

#endif
