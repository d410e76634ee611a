#ifndef shapetonBeltramiProjection_h
#define shapetonBeltramiProjection_h

#include "shapetonCylinderMap.h"
#include "shapetonProgress.h"

namespace shapeton
{
struct BeltramiProjectionOptions
{
  /** Greatest absolute value of the Beltrami coefficient, below 1. */
  double greatest{ 0.8 };
  int    iterations{ 12 };
  /** Called after each solve. */
  Progress progress;
};

struct BeltramiProjection
{
  CylinderNodes nodes;
  /** Flipped triangles before and after. */
  int    flipsBefore{ 0 };
  int    flips{ 0 };
  double greatestBefore{ 0.0 };
  double greatest{ 0.0 };
  int    iterations{ 0 };
};

/** Finds a nearby bijection. The Beltrami coefficient is clamped to `greatest` and smoothed there, and the map with
 * that coefficient is found from linear elliptic equations (linear Beltrami solver, Lui, Lam, Yau, Gu 2014), with the
 * ends of the source mapped to circles of the target as the only constraint. This is repeated with a tighter bound
 * while a triangle is flipped. A valid map is returned unchanged, except for its ends. `sourceAround` and
 * `targetAround` are the circumferences, mm. */
BeltramiProjection
ProjectToBijection(const CylinderNodes &             nodes,
                   double                            sourceAround,
                   double                            targetAround,
                   const BeltramiProjectionOptions & options = {});
} // namespace shapeton

#endif
