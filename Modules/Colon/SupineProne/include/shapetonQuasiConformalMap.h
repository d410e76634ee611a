#ifndef shapetonQuasiConformalMap_h
#define shapetonQuasiConformalMap_h

#include "shapetonBeltramiEquations.h"
#include "shapetonProgress.h"

#include <functional>

namespace shapeton
{
/** Linear constraint on one coordinate of a map in a triangle: the weighted sum of the corner values equals `value`,
 * mm. \ingroup ShapetonSupineProne */
struct MapCondition
{
  std::array<int, 3>    node{};
  std::array<double, 3> share{};
  double                value{ 0.0 };
};

/** Constraints on a map, at least one per coordinate. \ingroup ShapetonSupineProne */
struct MapConditions
{
  std::vector<MapCondition> along;
  std::vector<MapCondition> around;
};

/** The map for the Beltrami coefficient mu of each triangle, |mu| < 1, under the constraints: each coordinate minimizes
 * the energy (linear Beltrami solver, Lui, Lam, Yau, Gu 2014). It is harmonic for mu = 0. If constraints are given in
 * addition to those on the ends and the rotation of the cylinder, the coefficient of the map differs from mu.
 * Constraints hold to within rounding error; contradictory ones are satisfied in the least squares sense.
 * \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT CylinderValues
SolveBeltrami(const BeltramiEquations &               equations,
              const BeltramiEquations::Coefficients & mu,
              const MapConditions &                   conditions);

/** Options of FindQuasiConformalMap(). \ingroup ShapetonSupineProne */
struct QuasiConformalOptions
{
  /** Maximum absolute value of the coefficients, below 1. */
  double greatest{ 0.8 };
  /** Smoothing length of the coefficients, mm of the source. */
  double smoothing{ 8.0 };
  /** Maximum number of iterations. */
  int iterations{ 30 };
  /** Maximum change in a coefficient at convergence. */
  double tolerance{ 0.01 };
  /** Called after each solve. */
  Progress progress;
};

/** Result of FindQuasiConformalMap(). \ingroup ShapetonSupineProne */
struct QuasiConformalMap
{
  CylinderValues values;
  /** Number of flipped triangles, and maximum absolute value of a coefficient (above 1 if a triangle is flipped). */
  int    flips{ 0 };
  double greatest{ 0.0 };
  /** Number of solves. */
  int solves{ 0 };
  /** Maximum violation of a constraint (mm); nonzero only if constraints contradict each other. */
  double greatestMiss{ 0.0 };
};

/** Finds a quasi-conformal map through landmarks, after Lam and Lui 2014, starting with the harmonic map (mu = 0). The
 * Beltrami coefficient of each map is clamped to `greatest`, smoothed (the field nu that minimizes the integral of
 * smoothing^2 |grad nu|^2 + |nu - mu|^2), and prescribed for the next map. Landmarks are hard constraints in every
 * iteration, so triangles may remain flipped; these are counted.
 *
 * \param start initial positions of the nodes; used only for the first `conditionsOf`.
 * \param conditionsOf returns the constraints linearized about a map, which allows nonlinear constraints such as those
 * in other coordinates or on curves. Called for each map, and finally with a fixed coefficient until the constraints
 * converge; the fixed point must satisfy the original constraints. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT QuasiConformalMap
FindQuasiConformalMap(const BeltramiEquations &                                        equations,
                      CylinderValues                                                   start,
                      const std::function<MapConditions(const CylinderValues & map)> & conditionsOf,
                      const QuasiConformalOptions &                                    options = {});
} // namespace shapeton

#endif
