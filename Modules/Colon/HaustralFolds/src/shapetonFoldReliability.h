#ifndef shapetonFoldReliability_h
#define shapetonFoldReliability_h

#include "shapetonCurvatureMixture.h"
#include "shapetonFoldShape.h"

namespace shapeton
{
/** Gives a fold its reliability: twice the mean probability of its pixels to be fold and not wall, less 1; by the
 * published scheme the mean curvature over the far end of the interval. */
void
RateFold(const FoldPicture &         picture,
         const CurvatureMixture &    mixture,
         const HaustralFoldOptions & options,
         MeasuredFold &              measured);

/** Gives the ends of rated folds theirs: the whole one at the border or a taenia, half of it far away, as a Gaussian
 * of 10 mm. */
void
RateEnds(const FlatColonGrid & grid, const CurveSet * taeniae, std::vector<MeasuredFold> & folds);
} // namespace shapeton

#endif
