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
  /** After each map that is solved for. */
  Progress progress;
};

struct BeltramiProjection
{
  CylinderNodes nodes;
  /** Triangles turned over before and after. */
  int    flipsBefore{ 0 };
  int    flips{ 0 };
  double greatestBefore{ 0.0 };
  double greatest{ 0.0 };
  int    iterations{ 0 };
};

/** The nearest map found that is a bijection: its Beltrami coefficient is cut to `greatest` where it is larger,
 * smoothed there, and the map with that coefficient is found from linear elliptic equations (linear Beltrami solver,
 * Lui, Lam, Yau, Gu 2014), with the ends of the source mapped to circles of the target and no other constraint;
 * repeated, with a tighter bound, for as long as a triangle is turned over. A map that is good already comes back as it
 * is, but for its ends. `sourceAround` and `targetAround` are what a turn counts for, mm. */
BeltramiProjection
ProjectToBijection(const CylinderNodes &             nodes,
                   double                            sourceAround,
                   double                            targetAround,
                   const BeltramiProjectionOptions & options = {});
} // namespace shapeton

#endif
