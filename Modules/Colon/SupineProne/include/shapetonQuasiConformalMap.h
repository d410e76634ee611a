#ifndef shapetonQuasiConformalMap_h
#define shapetonQuasiConformalMap_h

#include "shapetonBeltramiEquations.h"
#include "shapetonProgress.h"

#include <functional>

namespace shapeton
{
/** Linear condition on one coordinate of a map at a point of a triangle: the weighted sum of its values at the corners
 * equals `value`, mm. \ingroup ShapetonSupineProne */
struct MapCondition
{
  std::array<int, 3>    node{};
  std::array<double, 3> share{};
  double                value{ 0.0 };
};

/** Conditions on a map. Each coordinate needs at least one. \ingroup ShapetonSupineProne */
struct MapConditions
{
  std::vector<MapCondition> along;
  std::vector<MapCondition> around;
};

/** The map with the Beltrami coefficient mu of each triangle, |mu| < 1, under the conditions: each coordinate minimizes
 * the energy (linear Beltrami solver, Lui, Lam, Yau, Gu 2014). With mu = 0 it is harmonic. If more than the ends of the
 * cylinder and its rotation is prescribed, the coefficient of the map differs from mu. Conditions hold to rounding
 * error; contradictory ones are violated as little as possible.
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
  /** Iteration stops when no coefficient changes by more. */
  double tolerance{ 0.01 };
  /** Called after each solve. */
  Progress progress;
};

/** Result of FindQuasiConformalMap(). \ingroup ShapetonSupineProne */
struct QuasiConformalMap
{
  CylinderValues values;
  /** Number of flipped triangles, and greatest absolute value of a coefficient; above 1 if a triangle is flipped. */
  int    flips{ 0 };
  double greatest{ 0.0 };
  /** Number of solves. */
  int solves{ 0 };
  /** Largest violation of a condition, mm: nonzero only if conditions contradict each other. */
  double greatestMiss{ 0.0 };
};

/** Finds a quasi-conformal map through landmarks, after Lam and Lui 2014. It starts with the harmonic map through them
 * (mu = 0). The Beltrami coefficient of each map is clamped to `greatest`, smoothed (the field nu that minimizes the
 * integral of smoothing^2 |grad nu|^2 + |nu - mu|^2), and prescribed to the next one. Landmarks are hard conditions in
 * every iteration, so a triangle may stay flipped where they leave no room; it is counted.
 *
 * \param start initial positions of the nodes; used only for the first `conditionsOf`.
 * \param conditionsOf returns the conditions linearized about a map, for data given in other coordinates than mm along
 * and around, or on a curve. Maps that satisfy them must satisfy the original conditions. It is called again for each
 * map, and finally for maps with the same coefficient until the conditions no longer change. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT QuasiConformalMap
FindQuasiConformalMap(const BeltramiEquations &                                        equations,
                      CylinderValues                                                   start,
                      const std::function<MapConditions(const CylinderValues & map)> & conditionsOf,
                      const QuasiConformalOptions &                                    options = {});
} // namespace shapeton

#endif
