#ifndef shapetonLungTrees_h
#define shapetonLungTrees_h

#include "shapetonPhantomRandom.h"
#include "shapetonTubeForest.h"

namespace shapeton
{
/** Points of a solid, at least `depth` mm inside, with a density of about one per spacing^3 mm^3: a lattice whose
 * points are randomly displaced by up to a third of the spacing. The solid is within `low` and `high`. */
std::vector<itk::Point<double, 3>>
ScatteredPoints(const PhantomSolid &          solid,
                const itk::Point<double, 3> & low,
                const itk::Point<double, 3> & high,
                double                        spacing,
                double                        depth,
                PhantomRandom &               random);

/** Appends a binary tree from `root` to all targets. A branch covers part of the distance to the center of its
 * targets and divides them across their longest extent. Radii follow r^2.8 = r1^2.8 + r2^2.8 (between Murray's 3
 * and 2.4 to 2.7 measured in lungs); `tipRadius` (mm) is that of a branch with one target. */
void
GrowTree(const itk::Point<double, 3> &      root,
         std::vector<itk::Point<double, 3>> targets,
         double                             tipRadius,
         PhantomRandom &                    random,
         std::vector<TaperedTube> &         tree);
} // namespace shapeton

#endif
