#ifndef shapetonGraphOnMesh_h
#define shapetonGraphOnMesh_h

#include "ShapetonGraphViewsExport.h"
#include "shapetonEmbeddingCertificate.h"
#include "shapetonProvenance.h"
#include "shapetonRemarks.h"
#include "shapetonSurfaceMesh.h"

#include <string>
#include <vector>

namespace shapeton
{
/** A graph on a triangle surface. \ingroup ShapetonGraphViews */
struct GraphOnMesh
{
  /** Nodes of the graph and points along its edges, on faces of the surface (LPS, mm). */
  std::vector<Eigen::Vector3d>              nodes;
  std::vector<std::vector<Eigen::Vector3d>> edges;
  /** Axis ratio of the affine map of the lattices of a torus; 1 on a sphere, where the map is conformal. */
  double dilatation{ 1.0 };
  /** Largest distance of a point from the developed surface, relative to the surface's size. Caused by rounding errors
   * or, on a torus with inverted faces, by gaps between faces. */
  double  gap{ 0.0 };
  Remarks warnings;
};

/** Maps an embedded graph onto a closed surface of the same genus, 0 or 1, by composition (dissertation 6.3.3): graph
 * to the sphere or flat torus by its certificate, surface to the sphere or flat torus by FlowSurface(), and between
 * them the identity of the spheres or the affine map of the lattices with the least dilatation. The rotation of the
 * sphere (and the Moebius transformation) and the translation of the torus are those of the two results; they have no
 * further meaning. Points between vertices of the surface are mapped linearly in its faces. Edges are geodesics of the
 * sphere or torus, sampled at about half an edge of the surface.
 *
 * Throws InputError with the prefix `what` if the genus is 2 or higher or differs from that of the graph, and as
 * FlowSurface() does. \ingroup ShapetonGraphViews */
ShapetonGraphViews_EXPORT GraphOnMesh
MapGraphOntoMesh(const EmbeddingCertificate & certificate, const SurfaceMesh & mesh, const std::string & what);

/** Writes nodes (points), edges (polylines) and the surface (triangles) as VTP, with the cell arrays kind (0 node, 1
 * edge, 2 triangle) and id, and the field array dilatation. Throws OutputError. \ingroup ShapetonGraphViews */
ShapetonGraphViews_EXPORT void
WriteGraphOnMesh(const GraphOnMesh & graph,
                 const SurfaceMesh & mesh,
                 const Provenance &  facts,
                 const std::string & path);
} // namespace shapeton

#endif
