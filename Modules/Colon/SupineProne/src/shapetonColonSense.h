#ifndef shapetonColonSense_h
#define shapetonColonSense_h

#include "shapetonColonCylinder.h"
#include "shapetonColonPosition.h"
#include "shapetonProgress.h"

#include <vector>

namespace shapeton
{
/** A colon, and the fold probability at each pixel of its grid. Non-owning. */
struct ColonWithFolds
{
  const ColonPosition &      position;
  const ColonCylinder &      cylinder;
  const std::vector<float> & folds;
};

/** Throws InputError if a colon fits better when reversed or mirrored. Uses only the ends and the folds. Returns the
 * energy of the best transformed warp minus the energy of the original one; about 0 for two patients. */
double
RequireSameSense(const ColonWithFolds & source, const ColonWithFolds & target, const Progress & progress);
} // namespace shapeton

#endif
