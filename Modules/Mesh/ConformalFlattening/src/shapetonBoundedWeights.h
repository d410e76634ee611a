#ifndef shapetonBoundedWeights_h
#define shapetonBoundedWeights_h

#include "shapetonSurfaceLaplacian.h"
#include "shapetonTubeCut.h"

#include <vector>

namespace shapeton
{
/** At this level all weights are 1, as in the map of Tutte (1963). */
constexpr int greatestWeightLevel = 6;

/** The edge weights of a Laplacian, clamped to [b, 1/b] where l, the larger level of the two vertices, is not 0: b =
 * .05, .1, .2, .4, .8 and 1 for l = 1 to 6. Positive weights map a tube without folds if its triangulation is simple
 * and no edge joins two vertices of one end: reflected at its ends it is a torus (Gortler, Gotsman and Thurston,
 * Discrete one-forms on meshes and applications to 3D mesh parameterization, 2006). */
Eigen::VectorXd
BoundedWeights(const SurfaceLaplacian & laplacian, const std::vector<int> & levels);

/** The Laplacian with these weights; unchanged if there are no levels. */
SurfaceLaplacian
WithBoundedWeights(SurfaceLaplacian laplacian, const std::vector<int> & levels);

/** Number of maps of one surface with clamped weights at flipped faces before another remedy is tried. */
constexpr int mostSolves = 8;

/** Rings around flipped faces in which weights change after map number `solve` (from 1): one ring from the third map
 * on. */
inline int
RingsOfSolve(int solve)
{
  return solve < 3 ? 0 : 1;
}

/** Raises the levels by 1 at the corners of marked faces and within the given number of rings around them. */
void
RaiseWeightLevels(const FaceMatrix &        F,
                  const EdgeGraph &         graph,
                  const std::vector<char> & isFlipped,
                  int                       rings,
                  std::vector<int> &        levels);
} // namespace shapeton

#endif
