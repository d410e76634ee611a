#ifndef shapetonQuadrilateralMap_h
#define shapetonQuadrilateralMap_h

#include "shapetonBoundaryLoops.h"
#include "shapetonProgress.h"
#include "shapetonSurfaceLaplacian.h"

namespace shapeton
{
/** The conformal map of a surface with one boundary and four corners on it to a rectangle. \ingroup ConformalFlattening
 */
struct QuadrilateralMap
{
  /** Vertices of the boundary, counterclockwise as seen from outside: they go to (0, 0), (1, 0), (1, 1), (0, 1). */
  std::array<int, 4> corners{};
  /** For each vertex, from 0 on the side of the corners 0 and 3 to 1 on that of 1 and 2. */
  Eigen::VectorXd u;
  /** For each vertex, from 0 on the side of the corners 0 and 1 to 1 on that of 2 and 3. */
  Eigen::VectorXd v;
  /** Two values of the modulus, height over width of the rectangle (5.2.5): modulusU = E(u), the integral of |grad
   * u|^2, is not less than the true one, modulusV = 1 / E(v) not greater (on a topological disk). */
  double modulusU{ 0.0 };
  double modulusV{ 0.0 };
};

/** Maps to a rectangle: u and v are harmonic, each with 0 and 1 on opposite sides and natural boundaries on the other
 * two, where a conformal map is perpendicular to them. The boundary then has no freedom left and none is chosen.
 *
 * With handles the same pair is conformal away from them as far as they are small (dissertation 5.2.5, where the handle
 * of a teapot collapses onto the plane); the gap of the two moduli tells.
 *
 * \param edgeLengths in any metric, such as that of heat diffusion.
 * \param boundary the only one of the surface.
 * \param corners four of its vertices in the order of the boundary, in either direction; if it runs clockwise the first
 * one stays and the others are taken in reverse.
 * \param weightLevels for each vertex 0, or from 1 to 6 how near to 1 the weights of its edges are brought so that no
 * face is flipped; empty: 0. The moduli are those of the metric all the same.
 * Throws InputError where a corner does not lie on the boundary, is named twice, or lies out of order, and as
 * MakeSurfaceLaplacian() does. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT QuadrilateralMap
MapQuadrilateral(const SurfaceConnectivity & connectivity,
                 const Eigen::VectorXd &     edgeLengths,
                 const BoundaryLoop &        boundary,
                 const std::array<int, 4> &  corners,
                 const std::vector<int> &    weightLevels = {},
                 const Progress &            progress = {});

/** Four vertices well spread on a boundary: the corners of a quadrilateral of large area that is inscribed in it. From
 * the quarters of its length that span most area each corner moves to where the area is largest until none can. A
 * rectangle has its own corners. Of equals the first along the boundary. \pre At least four vertices; else InputError.
 * \ingroup ConformalFlattening */
ConformalFlattening_EXPORT std::array<int, 4>
                           SpreadCorners(const BoundaryLoop & boundary, const VertexMatrix & V);
} // namespace shapeton

#endif
