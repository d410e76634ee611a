#ifndef shapetonSurfaceCut_h
#define shapetonSurfaceCut_h

#include "ConformalFlatteningExport.h"

#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** A surface cut open along paths of edges. \ingroup ConformalFlattening */
struct CutSurface
{
  /** The faces in their order, with the corners in their order. The vertices of the source keep their numbers; those
   * that the cut splits are followed by one more vertex for each further fan of faces. Point, cell and field arrays and
   * facts come along; indices of vertices in field arrays still name a vertex at the same place. */
  SurfaceMesh mesh;
  /** For each vertex of `mesh` the vertex of the source at its place. */
  std::vector<int> sourcePointId;
  /** For each path the corners 3 * face + k on its left: corners of faces that lie between the path and the left rim,
   * left as seen from outside (where faces are counterclockwise) by one who walks along the path. Ascending.
   *
   * This is what a function with a jump needs: values x on the vertices of the source become those of a function that
   * jumps by c across the path, x(left) = x(right) + c, when c is added at these corners. With several paths each
   * adds its own jump. A path that ends inside the surface has no left at that end: none of the corners there is
   * listed. */
  std::vector<std::vector<int>> leftCorners;
};

/** Cuts a surface open along paths, each a list of vertices of which neighbours share an edge. Paths may begin and end
 * on boundaries or inside, close (first vertex = last vertex), meet or cross. A vertex gets one copy for each fan of
 * faces that the cut leaves: the fan of its least face keeps the vertex, other fans follow in the order of their least
 * faces, vertices in ascending order.
 *
 * \pre The surface is manifold and consistently oriented. Throws InputError where it is not at the path, or where two
 * successive vertices share no edge. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT CutSurface
CutAlongPaths(const SurfaceMesh &                   mesh,
              const SurfaceConnectivity &           connectivity,
              const std::vector<std::vector<int>> & vertexPaths);

/** For each path of vertices the corners on its left, as in CutSurface, without cutting. \ingroup ConformalFlattening
 */
ConformalFlattening_EXPORT std::vector<int>
LeftCorners(const FaceMatrix & F, const SurfaceConnectivity & connectivity, const std::vector<int> & vertexPath);
} // namespace shapeton

#endif
