#ifndef shapetonSurfaceLaplacian_h
#define shapetonSurfaceLaplacian_h

#include "ShapetonSurfaceHeatExport.h"

#include "shapetonSurfaceConnectivity.h"

#include <Eigen/SparseCore>

#include <set>

namespace shapeton
{
/** Distribution of the surface area among the vertices. \ingroup ShapetonSurfaceHeat */
enum class MassLumping
{
  /** A third of each face to each corner. */
  Barycentric,
  /** Voronoi cells; an obtuse face gives half of its area to the obtuse corner and a quarter to each of the others
   * (Meyer et al., 2003). */
  MixedVoronoi
};

/** Mass lumping and minimum face height for MakeSurfaceLaplacian(). \ingroup ShapetonSurfaceHeat */
struct SurfaceLaplacianOptions
{
  MassLumping lumping{ MassLumping::Barycentric };
  /** Minimum face height, relative to the longest side. The stiffness of a flatter face is scaled down to that of a
   * face with this height: it stays positive semidefinite and cannot dominate its neighbors. */
  double leastHeight{ 1e-6 };
};

/** \class SurfaceLaplacian
 * \brief Cotangent stiffness L and lumped mass M of a triangle surface: the operator -div grad is M^-1 L. L is
 * symmetric, positive semidefinite and has row sums 0 (natural, that is, Neumann boundaries); u^T L u is the integral
 * of |grad u|^2 for the piecewise linear u (Pinkall and Polthier, 1993; dissertation 5.2.1 with the sign of the forward
 * heat equation). An edge weight is half the sum of the cotangents of the opposite angles. It is negative if these
 * angles sum to more than 180 degrees; L remains semidefinite, and only the maximum principle is lost.
 *
 * L depends only on edge lengths, so any metric on the surface has a Laplacian. Vertices and edges are numbered as in
 * SurfaceConnectivity. L is dimensionless; M is in mm^2.
 *
 * \ingroup ShapetonSurfaceHeat
 */
struct SurfaceLaplacian
{
  std::vector<std::array<int, 2>> edges;
  Eigen::VectorXd                 weights; ///< for each edge; L_ij = -weight
  Eigen::VectorXd                 mass;    ///< for each vertex
  /** Needles that were adjusted to leastHeight. */
  std::vector<int> clampedFaces;

  int
  NumberOfVertices() const
  {
    return static_cast<int>(mass.size());
  }
};

/** Straight edge lengths, in edge order (mm). \ingroup ShapetonSurfaceHeat */
ShapetonSurfaceHeat_EXPORT Eigen::VectorXd
                           EdgeLengths(const SurfaceConnectivity & connectivity, const VertexMatrix & V);

/** Laplacian of a surface with these edge lengths. Throws InputError if a length is not finite or not positive, a face
 * violates the triangle inequality by more than 1e-5 of its longest side, a face is degenerate, or a vertex has no
 * face. Smaller violations are treated as needles. \ingroup ShapetonSurfaceHeat */
ShapetonSurfaceHeat_EXPORT SurfaceLaplacian
MakeSurfaceLaplacian(const SurfaceConnectivity &     connectivity,
                     const Eigen::VectorXd &         edgeLengths,
                     const SurfaceLaplacianOptions & options = {});

/** Laplacian of the surface in space. Also throws InputError for zero-area faces (height below 1e-12 of the longest
 * side), which RepairSurface() cannot repair: remesh or simplify. \ingroup ShapetonSurfaceHeat */
ShapetonSurfaceHeat_EXPORT SurfaceLaplacian
MakeSurfaceLaplacian(const SurfaceConnectivity &     connectivity,
                     const VertexMatrix &            V,
                     const SurfaceLaplacianOptions & options = {});

/** Whether the lengths of each face form a triangle within the tolerance of MakeSurfaceLaplacian(). Other errors are
 * not checked. \ingroup ShapetonSurfaceHeat */
ShapetonSurfaceHeat_EXPORT bool
AreTriangles(const SurfaceConnectivity & connectivity, const Eigen::VectorXd & edgeLengths);

/** Repairs lengths with a small error, which affects the shortest side of a face most: a side that is too short for a
 * triangle is set to the difference of the other two. Returns the changed edges; some faces may still violate the
 * triangle inequality. Throws as MakeSurfaceLaplacian() does. \ingroup ShapetonSurfaceHeat */
ShapetonSurfaceHeat_EXPORT std::set<int>
LengthenShortestSides(const SurfaceConnectivity & connectivity, Eigen::VectorXd & edgeLengths);

/** The diagonal of L. \ingroup ShapetonSurfaceHeat */
ShapetonSurfaceHeat_EXPORT Eigen::VectorXd
                           StiffnessDiagonal(const SurfaceLaplacian & laplacian);

/** L as a full symmetric matrix. \ingroup ShapetonSurfaceHeat */
ShapetonSurfaceHeat_EXPORT Eigen::SparseMatrix<double>
                           StiffnessMatrix(const SurfaceLaplacian & laplacian);

/** u^T L u, the integral of |grad u|^2: twice the Dirichlet energy. \ingroup ShapetonSurfaceHeat */
ShapetonSurfaceHeat_EXPORT double
GradientEnergy(const SurfaceLaplacian & laplacian, const Eigen::VectorXd & u);

/** Throws InputError with the prefix `what` unless the surface is one manifold component without degenerate faces, as
 * diffusion distances require. \ingroup ShapetonSurfaceHeat */
ShapetonSurfaceHeat_EXPORT void
RequireOneManifold(const SurfaceConnectivity & connectivity, const std::string & what);
} // namespace shapeton

#endif
