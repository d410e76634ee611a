#ifndef shapetonSurfaceRepair_h
#define shapetonSurfaceRepair_h

#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** What RepairSurface() may do. \ingroup SurfaceMesh */
struct SurfaceRepairOptions
{
  /** Merge vertices at one position. */
  bool mergeVertices{ true };
  /** Merge vertices nearer than this, mm, from 0; the default 0 merges equal positions only. A chain of vertices, each
   * near the next, becomes one. */
  double mergeDistance{ 0.0 };
  /** Turn faces so that neighbours agree: those of a closed component look outwards, of an open one the fewest turn. */
  bool orient{ true };
  /** Cut where a surface is not manifold. */
  bool split{ true };
};

/** What RepairSurface() has done. \ingroup SurfaceMesh */
struct SurfaceRepairReport
{
  int mergedVertices{ 0 };
  int degenerateFaces{ 0 };
  int duplicateFaces{ 0 };
  int unreferencedVertices{ 0 };
  /** Vertices that were added where the surface was cut. */
  int addedVertices{ 0 };
  int turnedFaces{ 0 };
  /** Components that no turning makes consistent, such as a Moebius strip; left as they are. */
  int nonOrientableComponents{ 0 };

  /** In words, one for each kind of change; empty when nothing was done. */
  SurfaceMesh_EXPORT std::vector<std::string>
                     Words() const;
};

/** A manifold, consistently oriented surface of the same faces, in their order.
 *
 * In this order: coincident vertices are merged into the first one, faces that name a vertex twice and duplicates of
 * earlier faces are dropped, each edge with more than two faces and each vertex with several fans is cut (every fan of
 * faces that are connected by edges of two faces gets a vertex of its own), faces are turned, unreferenced vertices are
 * dropped. Vertices keep their order, added ones follow. Point arrays are copied to added vertices; arrays come along.
 * Cutting opens boundaries along non-manifold edges; the positions stay, so nothing is torn apart. Faces without area
 * but with three vertices stay, because dropping them would open holes. Field arrays are kept as they are: their
 * indices of vertices lose their meaning when vertices are merged or dropped.
 *
 * Throws InputError as RequireSound() does, and when every face is degenerate; ParameterError for a mergeDistance that
 * is negative or not finite. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT SurfaceMesh
RepairSurface(const SurfaceMesh &          mesh,
              const SurfaceRepairOptions & options = {},
              SurfaceRepairReport *        report = nullptr);

/** Whether a surface has what simplification and remeshing need: manifold, consistently oriented, without degenerate
 * faces. Returns its connectivity, by which that is told. Throws InputError that begins with `what`, names the first
 * fault and the repair. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT SurfaceConnectivity
RequireManifold(const SurfaceMesh & mesh, const std::string & what);
} // namespace shapeton

#endif
