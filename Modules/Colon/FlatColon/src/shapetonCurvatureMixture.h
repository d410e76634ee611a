#ifndef shapetonCurvatureMixture_h
#define shapetonCurvatureMixture_h

#include "shapetonFoldPicture.h"

namespace shapeton
{
/** Gaussian mixture of the curvature of the wall, of uneven wall (taeniae, noise, pouches), and of folds. */
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
  /** Whether folds are distinct from the wall and bulge into the lumen. */
  bool hasFolds{ false };

  /** Log-odds of fold versus wall, clamped to [-6, 6]. The priors are equal, since the fraction of folds varies between
   * colons. The sign is constant beyond the means, so a bulge stronger than a fold is also a fold. */
  double
  LogOdds(double curvature) const;
};

/** Expectation maximization over all pixels of the wall, weighted by surface area. */
CurvatureMixture
FitCurvatureMixture(const FoldPicture & picture);
} // namespace shapeton

#endif
