#ifndef shapetonBoundedWeights_h
#define shapetonBoundedWeights_h

#include "shapetonSurfaceLaplacian.h"
#include "shapetonTubeCut.h"

#include <vector>

namespace shapeton
{
/** At this level all weights are 1, as in the map of Tutte (1963). */
constexpr int greatestWeightLevel = 6;

/** The weights of the edges of a Laplacian, brought into [b, 1/b] where the greater level l of the two vertices is not
 * 0: b = .05, .1, .2, .4, .8 and 1 for l = 1 to 6. Where all weights are positive, a tube whose simple triangulation
 * has no edge between two vertices of one end is mapped without folds: reflected at its ends it is a torus (Gortler,
 * Gotsman and Thurston, Discrete one-forms on meshes and applications to 3D mesh parameterization, 2006). */
Eigen::VectorXd
BoundedWeights(const SurfaceLaplacian & laplacian, const std::vector<int> & levels);

/** The Laplacian with these weights; as it is for no levels. */
SurfaceLaplacian
WithBoundedWeights(SurfaceLaplacian laplacian, const std::vector<int> & levels);

/** Maps of one surface, with weights that are bounded where the map before had flipped faces, before something else is
 * done about them. */
constexpr int mostSolves = 8;

/** How far from flipped faces weights are to change after map number `solve`, counted from 1: one ring from the third
 * on. */
inline int
RingsOfSolve(int solve)
{
  return solve < 3 ? 0 : 1;
}

/** Raises by 1 the levels of the corners of marked faces and of so many rings around them. */
void
RaiseWeightLevels(const FaceMatrix &        F,
                  const EdgeGraph &         graph,
                  const std::vector<char> & isFlipped,
                  int                       rings,
                  std::vector<int> &        levels);
} // namespace shapeton

#endif
