#ifndef shapetonLungTrees_h
#define shapetonLungTrees_h

#include "shapetonPhantomRandom.h"
#include "shapetonTubeForest.h"

namespace shapeton
{
/** Points at least `depth` mm inside a solid, with a density of about one per spacing^3 mm^3: a lattice with random
 * displacements of up to a third of the spacing. `low` and `high` bound the solid. */
std::vector<itk::Point<double, 3>>
ScatteredPoints(const PhantomSolid &          solid,
                const itk::Point<double, 3> & low,
                const itk::Point<double, 3> & high,
                double                        spacing,
                double                        depth,
                PhantomRandom &               random);

/** Appends a binary tree from `root` to all targets. A branch covers part of the distance to the center of its targets
 * and splits them perpendicular to their longest extent. Radii satisfy r^2.8 = r1^2.8 + r2^2.8 (exponent between
 * Murray's 3 and 2.4 to 2.7 measured in lungs); `tipRadius` (mm) is the radius of a branch with one target. */
void
GrowTree(const itk::Point<double, 3> &      root,
         std::vector<itk::Point<double, 3>> targets,
         double                             tipRadius,
         PhantomRandom &                    random,
         std::vector<TaperedTube> &         tree);
} // namespace shapeton

#endif
