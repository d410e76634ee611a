#ifndef shapetonSurfaceLaplacian_h
#define shapetonSurfaceLaplacian_h

#include "HeatDiffusionMetricExport.h"

#include "shapetonSurfaceConnectivity.h"

#include <Eigen/SparseCore>

#include <set>

namespace shapeton
{
/** How the area of a surface is shared among its vertices. \ingroup HeatDiffusionMetric */
enum class MassLumping
{
  /** A third of each face to each corner. */
  Barycentric,
  /** Voronoi cells; in an obtuse face half of it to the obtuse corner, a quarter to the others (Meyer et al., 2003). */
  MixedVoronoi
};

/** Mass and least height of faces for MakeSurfaceLaplacian(). \ingroup HeatDiffusionMetric */
struct SurfaceLaplacianOptions
{
  MassLumping lumping{ MassLumping::Barycentric };
  /** A face whose least height is below this part of its longest side is taken to have that height: its stiffness is
   * scaled down, so that it stays positive semidefinite, and cannot swamp that of its neighbours. */
  double leastHeight{ 1e-6 };
};

/** \class SurfaceLaplacian
 * \brief Cotangent stiffness L and lumped mass M of a triangle surface: the operator -div grad is M^-1 L.
 *
 * L is symmetric, positive semidefinite and has row sums 0 (natural, that is Neumann boundaries); u^T L u is the
 * integral of |grad u|^2 for the piecewise linear u (Pinkall and Polthier, 1993; dissertation 5.2.1 with the sign of
 * the forward heat equation). The weight of an edge is half the sum of the cotangents of the angles opposite to it. It
 * is negative where these exceed 180 degrees together; L stays semidefinite there, only the maximum principle is lost.
 *
 * Only lengths of edges count, so there is a Laplacian for any metric on the surface. Vertices and edges are numbered
 * as in SurfaceConnectivity. Unit of L: 1, of M: mm^2.
 *
 * \ingroup HeatDiffusionMetric
 */
struct SurfaceLaplacian
{
  std::vector<std::array<int, 2>> edges;
  Eigen::VectorXd                 weights; ///< for each edge; L_ij = -weight
  Eigen::VectorXd                 mass;    ///< for each vertex
  /** Needles that were given leastHeight. */
  std::vector<int> clampedFaces;

  int
  NumberOfVertices() const
  {
    return static_cast<int>(mass.size());
  }
};

/** The straight lengths of the edges, in their order; mm. \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT Eigen::VectorXd
                           EdgeLengths(const SurfaceConnectivity & connectivity, const VertexMatrix & V);

/** The Laplacian of a surface with these lengths of edges. Throws InputError where a length is not finite or not
 * positive, lengths of a face break the triangle inequality by more than 1e-5 of the longest, a face is degenerate, or
 * a vertex has no face. Lengths that break it by less are taken for a needle. \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT SurfaceLaplacian
MakeSurfaceLaplacian(const SurfaceConnectivity &     connectivity,
                     const Eigen::VectorXd &         edgeLengths,
                     const SurfaceLaplacianOptions & options = {});

/** The Laplacian of the surface in space; throws InputError also for faces without area (a height below 1e-12 of the
 * longest side), which RepairSurface() cannot mend: remesh, or simplify. \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT SurfaceLaplacian
MakeSurfaceLaplacian(const SurfaceConnectivity &     connectivity,
                     const VertexMatrix &            V,
                     const SurfaceLaplacianOptions & options = {});

/** Whether the lengths of each face are those of a triangle, as far as MakeSurfaceLaplacian() asks. Other errors are
 * left to it. \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT bool
AreTriangles(const SurfaceConnectivity & connectivity, const Eigen::VectorXd & edgeLengths);

/** For lengths that are known but for a small error, of which the shortest side of a face has least left: where it is
 * too short for a triangle, it becomes as long as the difference of the other two. Gives the edges that were changed;
 * faces may be left that are no triangles. Errors as those of MakeSurfaceLaplacian(). \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT std::set<int>
LengthenShortestSides(const SurfaceConnectivity & connectivity, Eigen::VectorXd & edgeLengths);

/** The diagonal of L. \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT Eigen::VectorXd
                           StiffnessDiagonal(const SurfaceLaplacian & laplacian);

/** L with both triangles. \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT Eigen::SparseMatrix<double>
                           StiffnessMatrix(const SurfaceLaplacian & laplacian);

/** u^T L u, the integral of |grad u|^2: twice the Dirichlet energy. \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT double
GradientEnergy(const SurfaceLaplacian & laplacian, const Eigen::VectorXd & u);

/** Throws InputError, which begins with `what`, unless the surface is one manifold component whose faces all have three
 * corners: what diffusion distances are defined for. \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT void
RequireOneManifold(const SurfaceConnectivity & connectivity, const std::string & what);
} // namespace shapeton

#endif
