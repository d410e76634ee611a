#ifndef shapetonConjugateFunction_h
#define shapetonConjugateFunction_h

#include "shapetonFlatDistortion.h"
#include "shapetonHarmonicSolver.h"

namespace shapeton
{
/** One value for each corner 3 * face + k. */
using CornerValues = std::vector<double>;

/** Corner values of a vertex function with a jump: adds 1 at the corners left of the cut. */
CornerValues
LiftedValues(const FaceMatrix & F, const Eigen::VectorXd & values, const std::vector<int> & leftCorners);

/** The harmonic function with natural boundaries that is larger by 1 on the left of the cut, up to a constant. The
 * solver has one fixed vertex. */
Eigen::VectorXd
SolveWithUnitJump(const SurfaceLaplacian &    laplacian,
                  const HarmonicSolver &      solver,
                  const FaceMatrix &          F,
                  const SurfaceConnectivity & connectivity,
                  const std::vector<int> &    leftCorners);

/** The integral of |grad x|^2 for a function linear in each face, with one difference along each edge. */
double
EnergyOfCorners(const SurfaceLaplacian &    laplacian,
                const SurfaceConnectivity & connectivity,
                const FaceMatrix &          F,
                const CornerValues &        values);

/** Differences of the published conjugate along the edges, directed from the lower vertex index: the gradient of u in
 * each face, rotated clockwise by 90 degrees as seen from outside, averaged over the faces of the edge. */
Eigen::VectorXd
AveragedHodgeStar(const FaceMatrix &          F,
                  const SurfaceConnectivity & connectivity,
                  const SideLengths &         sides,
                  const Eigen::VectorXd &     u);

/** Number of turns to add to the values of each face to make them continuous on a cut surface; the first face keeps its
 * values. The input is continuous in each face and, up to whole turns, across edges. Returns false if no solution
 * exists. */
bool
TurnsOfFaces(const FaceMatrix &          F,
             const SurfaceConnectivity & connectivity,
             const CutSurface &          cut,
             const CornerValues &        values,
             std::vector<int> &          turns);

/** Sums of differences along a breadth-first edge tree of a cut surface from vertex 0. Edges and differences refer to
 * the uncut surface. */
Eigen::VectorXd
IntegrateAlongTree(const CutSurface &          cut,
                   const SurfaceConnectivity & connectivity,
                   const Eigen::VectorXd &     differences);
} // namespace shapeton

#endif
