#ifndef shapetonCurvatureMixture_h
#define shapetonCurvatureMixture_h

#include "shapetonFoldPicture.h"

namespace shapeton
{
/** Curvature of the wall, of what is uneven in it (taeniae, noise, pouches), and of folds, each normally distributed.
 */
struct CurvatureMixture
{
  struct Class
  {
    double mean;
    double deviation;
    double share;
  };
  Class wall;
  Class uneven;
  Class fold;
  /** Folds stand out from the wall and bulge into the lumen. */
  bool hasFolds{ false };

  /** Logarithm of the odds of a fold against all else, both equally probable beforehand, cut to [-6, 6]: how much of
   * the wall is folds differs between colons, what a fold looks like does not. Beyond the means it keeps its sign: what
   * bulges more than a fold does is none the less one. */
  double
  LogOdds(double curvature) const;
};

/** By expectation and maximisation over all pixels of the wall, each with its area on the surface. */
CurvatureMixture
FitCurvatureMixture(const FoldPicture & picture);
} // namespace shapeton

#endif
