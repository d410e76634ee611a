#ifndef shapetonSurfaceCut_h
#define shapetonSurfaceCut_h

#include "ShapetonConformalFlatteningExport.h"

#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** A surface cut open along paths of edges. \ingroup ShapetonConformalFlattening */
struct CutSurface
{
  /** The faces in their original order and corner order. Source vertices keep their indices; copies of split vertices
   * are appended, one for each additional fan of faces. Point, cell and field arrays and facts are kept; vertex indices
   * in field arrays still name a vertex at the same position. */
  SurfaceMesh mesh;
  /** For each vertex of `mesh`, the source vertex at the same position. */
  std::vector<int> sourcePointId;
  /** For each path, the corners 3 * face + k on its left, ascending. "Left" is relative to the direction of the path,
   * seen from outside (where faces are counterclockwise).
   *
   * Use these corners to define a function with a jump: take its values on the source vertices and add c at these
   * corners, so that x(left) = x(right) + c. Jumps of several paths add up. A path that ends inside the surface has no
   * left side at that end, so no corner there is listed. */
  std::vector<std::vector<int>> leftCorners;
};

/** Cuts a surface open along paths. Each path is a list of vertices; successive vertices share an edge. Paths may start
 * and end on boundaries or inside, close (first vertex = last vertex), meet or cross. Each vertex gets one copy for
 * each fan of faces that the cut leaves. The fan with the lowest face keeps the vertex. Copies are appended in
 * ascending order of the vertices, and for each vertex in the order of the lowest faces of its fans.
 *
 * \pre The surface is manifold and consistently oriented. Throws InputError if this does not hold along the path, or if
 * two successive vertices do not share an edge. \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT CutSurface
CutAlongPaths(const SurfaceMesh &                   mesh,
              const SurfaceConnectivity &           connectivity,
              const std::vector<std::vector<int>> & vertexPaths);

/** For each path of vertices, the corners on its left as in CutSurface, without cutting.
 * \ingroup ShapetonConformalFlattening
 */
ShapetonConformalFlattening_EXPORT std::vector<int>
LeftCorners(const FaceMatrix & F, const SurfaceConnectivity & connectivity, const std::vector<int> & vertexPath);
} // namespace shapeton

#endif
