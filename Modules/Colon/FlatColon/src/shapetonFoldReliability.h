#ifndef shapetonFoldReliability_h
#define shapetonFoldReliability_h

#include "shapetonCurvatureMixture.h"
#include "shapetonFoldShape.h"

namespace shapeton
{
/** Sets the reliability of a fold: twice the mean fold probability of its pixels, minus 1; for the published scheme the
 * mean curvature over the far end of the interval. */
void
RateFold(const FoldPicture &         picture,
         const CurvatureMixture &    mixture,
         const HaustralFoldOptions & options,
         MeasuredFold &              measured);

/** Sets the reliability of the ends of rated folds: that of the fold at the border or a taenia, half of it far away, as
 * a Gaussian of 10 mm. */
void
RateEnds(const FlatColonGrid & grid, const CurveSet * taeniae, std::vector<MeasuredFold> & folds);
} // namespace shapeton

#endif
