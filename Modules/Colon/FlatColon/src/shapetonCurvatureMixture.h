#ifndef shapetonCurvatureMixture_h
#define shapetonCurvatureMixture_h

#include "shapetonFoldPicture.h"

namespace shapeton
{
/** Normal distributions of the curvature of the wall, of its unevenness (taeniae, noise, pouches), and of folds. */
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

  /** Log-odds of a fold against the rest with equal priors, clamped to [-6, 6]: the share of folds differs between
   * colons, their shape does not. Beyond the means the sign is kept, so a bulge stronger than a fold still counts as a
   * fold. */
  double
  LogOdds(double curvature) const;
};

/** Expectation maximization over all pixels of the wall, weighted by their area on the surface. */
CurvatureMixture
FitCurvatureMixture(const FoldPicture & picture);
} // namespace shapeton

#endif
