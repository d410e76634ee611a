#ifndef shapetonCurvatureNewton_h
#define shapetonCurvatureNewton_h

#include "shapetonConformalMetric.h"
#include "shapetonProgress.h"

namespace shapeton
{
/** Unknowns of a Ricci flow. */
struct RicciUnknowns
{
  /** For each vertex of the triangulation, its unknown; both copies in a double have the same one. */
  std::vector<int> ofVertices;
  /** Number of copies of the surface: 1, or 2 for a double. */
  int copies{ 1 };
  /** For each unknown, the angle sum of its vertices divided by the number of copies. Not used if it is fixed. */
  Eigen::VectorXd angles;
  /** Unknowns that keep their initial value. */
  std::vector<char> isFixed;
  /** Unknown that keeps its value because the angles do not depend on the scale, or -1. */
  int gauge{ -1 };
};

/** Largest curvature errors (radians) at which the flow ends, and at which it may end if rounding errors prevent
 * further progress. */
struct RicciTolerance
{
  double goal{ 2e-11 };
  double accepted{ 1e-10 };
};

struct RicciSolution
{
  Eigen::VectorXd u; ///< for each unknown
  /** Largest difference of an angle sum from the target (radians). */
  double residual{ 0.0 };
  int    steps{ 0 };
};

/** Minimizes the convex energy with the gradient curvature - target by Newton's method. A step is halved until the
 * slope of the energy at its end is negative, or the gradient is smaller and the slope at most half the initial
 * descent. On return, `metric` has the factors of the solution. Throws InputError if no step helps or the Hessian is
 * not positive definite. */
RicciSolution
SolveForCurvature(ConformalMetric &       metric,
                  const RicciUnknowns &   unknowns,
                  const Eigen::VectorXd & start,
                  const RicciTolerance &  tolerance,
                  const Progress &        progress);
} // namespace shapeton

#endif
