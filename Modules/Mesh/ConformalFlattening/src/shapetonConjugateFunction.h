#ifndef shapetonConjugateFunction_h
#define shapetonConjugateFunction_h

#include "shapetonFlatDistortion.h"
#include "shapetonHarmonicSolver.h"

namespace shapeton
{
/** For each corner 3 * face + k a value. */
using CornerValues = std::vector<double>;

/** A function of vertices with a jump, corner by corner: 1 is added at the corners left of the cut. */
CornerValues
LiftedValues(const FaceMatrix & F, const Eigen::VectorXd & values, const std::vector<int> & leftCorners);

/** The harmonic function with natural boundaries that is greater by 1 on the left of the cut, up to a constant. The
 * solver has one fixed vertex. */
Eigen::VectorXd
SolveWithUnitJump(const SurfaceLaplacian &    laplacian,
                  const HarmonicSolver &      solver,
                  const FaceMatrix &          F,
                  const SurfaceConnectivity & connectivity,
                  const std::vector<int> &    leftCorners);

/** The integral of |grad x|^2 for a function that is linear in each face and has one difference along each edge. */
double
EnergyOfCorners(const SurfaceLaplacian &    laplacian,
                const SurfaceConnectivity & connectivity,
                const FaceMatrix &          F,
                const CornerValues &        values);

/** The differences along the edges, from the lesser vertex on, of the published conjugate: the gradient of u turned by
 * 90 degrees in each face, clockwise as seen from outside, averaged over the faces of the edge. */
Eigen::VectorXd
AveragedHodgeStar(const FaceMatrix &          F,
                  const SurfaceConnectivity & connectivity,
                  const SideLengths &         sides,
                  const Eigen::VectorXd &     u);

/** By how many turns the values of each face have to be raised so that they are continuous on a cut surface; the first
 * face keeps its own. The values are continuous in each face and, but for whole turns, across edges. The answer is
 * false where that cannot be. */
bool
TurnsOfFaces(const FaceMatrix &          F,
             const SurfaceConnectivity & connectivity,
             const CutSurface &          cut,
             const CornerValues &        values,
             std::vector<int> &          turns);

/** The sums of differences along a tree of edges of a cut surface, breadth first from vertex 0. The edges and the
 * differences are those of the whole surface. */
Eigen::VectorXd
IntegrateAlongTree(const CutSurface &          cut,
                   const SurfaceConnectivity & connectivity,
                   const Eigen::VectorXd &     differences);
} // namespace shapeton

#endif
