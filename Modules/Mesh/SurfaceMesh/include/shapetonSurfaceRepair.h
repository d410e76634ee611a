#ifndef shapetonSurfaceRepair_h
#define shapetonSurfaceRepair_h

#include "shapetonSurfaceConnectivity.h"
#include "shapetonSurfaceRepairOptions.h"

namespace shapeton
{
/** Report of RepairSurface(). \ingroup ShapetonSurfaceMesh */
struct SurfaceRepairReport
{
  int mergedVertices{ 0 };
  int degenerateFaces{ 0 };
  int duplicateFaces{ 0 };
  int unreferencedVertices{ 0 };
  /** Number of vertices added by cuts. */
  int addedVertices{ 0 };
  int turnedFaces{ 0 };
  /** Number of nonorientable components, such as a Moebius strip; left unchanged. */
  int nonOrientableComponents{ 0 };

  /** One line per kind of change; empty if nothing changed. */
  ShapetonSurfaceMesh_EXPORT std::vector<std::string>
                             Words() const;
};

/** Turns a surface into a manifold, consistently oriented one with the same faces in the same order.
 *
 * Steps, in order: merge coincident vertices into the first one; drop faces with a repeated vertex and duplicates of
 * earlier faces; cut non-manifold edges and vertices, so that each fan of faces connected by edges with two faces has
 * its own vertex; orient faces; drop unreferenced vertices. Vertices keep their order, followed by added ones. Point
 * arrays are copied to added vertices; other arrays are kept. The cuts create boundaries along non-manifold edges
 * without moving vertices. Zero-area faces with three distinct vertices are kept because dropping them would open
 * holes. Field arrays are not changed: vertex indices in them become invalid if vertices are merged or dropped.
 *
 * Throws InputError as RequireSound() does, and if every face is degenerate. Throws ParameterError if mergeDistance is
 * negative or not finite. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT SurfaceMesh
RepairSurface(const SurfaceMesh &          mesh,
              const SurfaceRepairOptions & options = {},
              SurfaceRepairReport *        report = nullptr);

/** Checks the requirements of simplification and remeshing: manifold, consistently oriented, no degenerate faces.
 * Returns the connectivity used for the check. Throws InputError with the prefix `what`, the first defect and the
 * repair. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT SurfaceConnectivity
RequireManifold(const SurfaceMesh & mesh, const std::string & what);
} // namespace shapeton

#endif
