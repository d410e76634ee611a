#ifndef shapetonBeltramiProjection_h
#define shapetonBeltramiProjection_h

#include "shapetonCylinderMap.h"
#include "shapetonProgress.h"

namespace shapeton
{
struct BeltramiProjectionOptions
{
  /** Maximum absolute value of the Beltrami coefficient, below 1. */
  double greatest{ 0.8 };
  int    iterations{ 12 };
  /** Called after each solve. */
  Progress progress;
};

struct BeltramiProjection
{
  CylinderNodes nodes;
  /** Number of flipped triangles before and after the projection. */
  int    flipsBefore{ 0 };
  int    flips{ 0 };
  double greatestBefore{ 0.0 };
  double greatest{ 0.0 };
  int    iterations{ 0 };
};

/** Finds a nearby bijection. The Beltrami coefficient is clamped to `greatest` and locally smoothed, and the map for
 * that coefficient is computed (linear Beltrami solver, Lui, Lam, Yau, Gu 2014), constrained only at the ends, which
 * map to circles. This is repeated with a tighter bound as long as triangles are flipped. A valid map is returned
 * unchanged, except for its ends. `sourceAround` and `targetAround` are the circumferences, mm. */
BeltramiProjection
ProjectToBijection(const CylinderNodes &             nodes,
                   double                            sourceAround,
                   double                            targetAround,
                   const BeltramiProjectionOptions & options = {});
} // namespace shapeton

#endif
