#ifndef itkFoldReliability_h
#define itkFoldReliability_h

#include "itkCurvatureMixture.h"
#include "itkFoldShape.h"

namespace itk
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
} // namespace itk

#endif
