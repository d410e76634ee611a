#ifndef shapetonQuasiConformalMap_h
#define shapetonQuasiConformalMap_h

#include "shapetonBeltramiEquations.h"
#include "shapetonProgress.h"

#include <functional>

namespace shapeton
{
/** One coordinate of a map is known at a place within a triangle: shares times what it is at the corners add up to
 * `value`, mm. \ingroup SupineProne */
struct MapCondition
{
  std::array<int, 3>    node{};
  std::array<double, 3> share{};
  double                value{ 0.0 };
};

/** All that is known of a map. For each coordinate there must be something. \ingroup SupineProne */
struct MapConditions
{
  std::vector<MapCondition> along;
  std::vector<MapCondition> around;
};

/** The map with the Beltrami coefficient mu of each triangle, |mu| < 1, that keeps the conditions: each coordinate has
 * the least energy of all that do (linear Beltrami solver, Lui, Lam, Yau, Gu 2014). With mu = 0 it is harmonic. Where
 * conditions are more than the ends of the cylinder and its rotation, the coefficient of the map is another one.
 * Conditions hold to rounding; those that contradict each other are missed as little as can be.
 * \ingroup SupineProne */
SupineProne_EXPORT CylinderValues
SolveBeltrami(const BeltramiEquations &               equations,
              const BeltramiEquations::Coefficients & mu,
              const MapConditions &                   conditions);

/** For FindQuasiConformalMap(). \ingroup SupineProne */
struct QuasiConformalOptions
{
  /** Coefficients are cut to this absolute value, below 1. */
  double greatest{ 0.8 };
  /** mm of the source over which they are smoothed. */
  double smoothing{ 8.0 };
  /** Rounds at most. */
  int iterations{ 30 };
  /** The rounds end when no coefficient changes by more. */
  double tolerance{ 0.01 };
  /** After each map that is solved for. */
  Progress progress;
};

/** See FindQuasiConformalMap(). \ingroup SupineProne */
struct QuasiConformalMap
{
  CylinderValues values;
  /** Triangles turned over, and the greatest absolute value of a coefficient where none is; above 1 elsewhere. */
  int    flips{ 0 };
  double greatest{ 0.0 };
  /** Maps that were solved for. */
  int solves{ 0 };
  /** By how much a condition is missed at most, mm: not at all, but where some contradict each other. */
  double greatestMiss{ 0.0 };
};

/** A quasi-conformal map through landmarks, after Lam and Lui 2014: beginning with the harmonic map through them (mu =
 * 0), the Beltrami coefficient of each map is cut to `greatest`, smoothed (the field nu that minimises the integral of
 * smoothing^2 |grad nu|^2 + |nu - mu|^2), and prescribed to the next one. Landmarks are hard conditions in every
 * round, so that a triangle may stay turned over where they leave no room; it is counted.
 *
 * \param start where the nodes lie at first; decides nothing but the first `conditionsOf`.
 * \param conditionsOf all that is known, as seen from a map: what is known in another coordinate than mm along and
 * around, or on a curve, gives linear conditions about it. Maps that keep them must keep what is known; they are asked
 * for again about each map, and at last about maps with the same coefficient, until they stay. \ingroup SupineProne */
SupineProne_EXPORT QuasiConformalMap
FindQuasiConformalMap(const BeltramiEquations &                                        equations,
                      CylinderValues                                                   start,
                      const std::function<MapConditions(const CylinderValues & map)> & conditionsOf,
                      const QuasiConformalOptions &                                    options = {});
} // namespace shapeton

#endif
