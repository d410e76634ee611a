#ifndef shapetonColonSense_h
#define shapetonColonSense_h

#include "shapetonColonCylinder.h"
#include "shapetonColonPosition.h"
#include "shapetonProgress.h"

#include <vector>

namespace shapeton
{
/** A colon with the probability of a fold at each pixel of its grid. Nothing is owned. */
struct ColonWithFolds
{
  const ColonPosition &      position;
  const ColonCylinder &      cylinder;
  const std::vector<float> & folds;
};

/** Throws InputError where a colon fits better when it is turned: then it runs the other way, or is a mirror image.
 * Nothing but the ends and the folds is used. Returns by how much the energy of the best turned warp exceeds that of
 * the straight one; two patients have about 0. */
double
RequireSameSense(const ColonWithFolds & source, const ColonWithFolds & target, const Progress & progress);
} // namespace shapeton

#endif
