#ifndef shapetonQuadrilateralMap_h
#define shapetonQuadrilateralMap_h

#include "shapetonBoundaryLoops.h"
#include "shapetonProgress.h"
#include "shapetonSurfaceLaplacian.h"

namespace shapeton
{
/** Conformal map of a surface with one boundary, and four corners on it, to a rectangle.
 * \ingroup ShapetonConformalFlattening */
struct QuadrilateralMap
{
  /** Boundary vertices, counterclockwise as seen from outside, mapped to (0, 0), (1, 0), (1, 1), (0, 1). */
  std::array<int, 4> corners{};
  /** Harmonic u at each vertex: 0 on the side of corners 0 and 3, 1 on the side of corners 1 and 2. */
  Eigen::VectorXd u;
  /** Harmonic v at each vertex: 0 on the side of corners 0 and 1, 1 on the side of corners 2 and 3. */
  Eigen::VectorXd v;
  /** Two estimates of the modulus, height over width of the rectangle (5.2.5). On a topological disk modulusU = E(u),
   * the integral of |grad u|^2, is an upper bound and modulusV = 1 / E(v) a lower bound. */
  double modulusU{ 0.0 };
  double modulusV{ 0.0 };
};

/** Maps to a rectangle. u and v are harmonic, each 0 and 1 on opposite sides, with natural boundaries on the other two,
 * which a conformal map meets at right angles. This determines the boundary map.
 *
 * With handles the pair is conformal away from small handles (dissertation 5.2.5, where the handle of a teapot
 * collapses onto the plane); the gap between the two moduli measures the error.
 *
 * \param edgeLengths in any metric, such as that of heat diffusion.
 * \param boundary the only boundary of the surface.
 * \param corners four boundary vertices in boundary order, in either direction. If the boundary runs clockwise, the
 * first one is kept and the others are reversed.
 * \param weightLevels for each vertex, how close to 1 the weights of its edges are clamped to avoid flipped faces: 1 to
 * 6, or 0 for no clamping. Empty means 0 everywhere. The moduli are those of the metric in any case. Throws InputError
 * if a corner is not on the boundary, repeated or out of order, and as MakeSurfaceLaplacian() does.
 * \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT QuadrilateralMap
MapQuadrilateral(const SurfaceConnectivity & connectivity,
                 const Eigen::VectorXd &     edgeLengths,
                 const BoundaryLoop &        boundary,
                 const std::array<int, 4> &  corners,
                 const std::vector<int> &    weightLevels = {},
                 const Progress &            progress = {});

/** Finds four well spread boundary vertices: the corners of an inscribed quadrilateral of large area. The search starts
 * with four points that divide the boundary length into quarters, at the position of largest area. Each corner then
 * moves to its best position until no move increases the area. A rectangle keeps its own corners. Ties go to the first
 * vertex along the boundary. \pre There are at least four vertices; otherwise throws InputError.
 * \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT std::array<int, 4>
                                   SpreadCorners(const BoundaryLoop & boundary, const VertexMatrix & V);
} // namespace shapeton

#endif
