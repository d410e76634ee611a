#ifndef itkCurvatureMixture_h
#define itkCurvatureMixture_h

#include "itkFoldPicture.h"

namespace itk
{
/** Curvature of wall and of folds, each normally distributed. */
struct CurvatureMixture
{
  struct Class
  {
    double mean;
    double deviation;
    double share;
  };
  Class wall;
  Class fold;
  /** The two stand out from each other enough, and folds bulge into the lumen. */
  bool hasFolds{ false };

  /** Logarithm of the odds of a fold, cut to [-6, 6]. Beyond the means it keeps its sign: what bulges more than a fold
   * does is none the less one. */
  double
  LogOdds(double curvature) const;
};

/** By expectation and maximisation over all pixels of the wall, each with its area on the surface. */
CurvatureMixture
FitCurvatureMixture(const FoldPicture & picture);
} // namespace itk

#endif
