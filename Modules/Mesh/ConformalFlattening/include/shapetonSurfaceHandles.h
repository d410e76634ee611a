#ifndef shapetonSurfaceHandles_h
#define shapetonSurfaceHandles_h

#include "shapetonFlatDistortion.h"

namespace shapeton
{
/** A handle, or a group of close handles, of a flattened surface. \ingroup ShapetonConformalFlattening */
struct SurfaceHandle
{
  /** Number of handles; more than 1 if several are too close to separate. */
  int genus{ 0 };
  /** Mean of its vertices (LPS, mm). */
  Eigen::Vector3d place{ Eigen::Vector3d::Zero() };
  /** Mean position of its faces in the plane. */
  Eigen::Vector2d flatPlace{ Eigen::Vector2d::Zero() };
  /** Largest distance of its vertices from `place` (mm). */
  double radius{ 0.0 };
  /** Its vertices on the flattened surface, including one ring around the singular ones; ascending. */
  std::vector<int> vertices;
};

/** Handles of a flat tube, with the number of false detections. See DetectHandles().
 * \ingroup ShapetonConformalFlattening */
struct HandleDetection
{
  /** In the order of their first vertices. */
  std::vector<SurfaceHandle> handles;
  /** Number of clusters of singular vertices without a handle. */
  int falseAlarms{ 0 };
  /** Total genus of the handles. */
  int genus{ 0 };
};

/** Finds the handles of a surface from its flat map (dissertation 5.4.3).
 *
 * A flat map has angle defects only at folds, and handles always cause folds. Vertices with a defect above 1e-6,
 * dilated by one ring, form clusters. By Gauss-Bonnet the defects of a cluster sum to -4 pi times its genus; clusters
 * with sum 0 are false alarms. Elsewhere the map must be free of folds, as FlattenTube() with the Laplacian produces in
 * any metric.
 *
 * \param connectivity of the surface before the cut.
 * \param flat the flat surface, with the same faces in the same order.
 * Throws InputError if `flat` is not a flat surface of `connectivity`. \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT HandleDetection
DetectHandles(const SurfaceConnectivity & connectivity, const SurfaceMesh & flat);

/** Marks the faces with a corner at most this many edges away from a handle vertex.
 * \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT std::vector<char>
FacesNearHandles(const SurfaceConnectivity & connectivity, const std::vector<SurfaceHandle> & handles, int rings);
/** A surface after handle removal. \ingroup ShapetonConformalFlattening */
struct HandleRemoval
{
  /** Point arrays of new vertices are means over the rim of the hole; cell arrays of new faces are 0, and the cell
   * array `filled` is 1 there. `rectumLoop` and `cecumLoop` are renumbered. */
  SurfaceMesh mesh;
  int         removedFaces{ 0 };
  int         filledHoles{ 0 };
  int         filledFaces{ 0 };
  /** Total genus of the remaining handles; handles next to a boundary are not removed. */
  int genus{ 0 };
};

/** Deletes the handle vertices with their faces and any parts this disconnects, and fills the holes with triangles as
 * large as those around them (Liepa, Filling holes in meshes, 2003). The filling minimizes bending: the sum of squared
 * uniform Laplacians at new vertices and at the rim. Boundaries are unchanged.
 *
 * \pre The surface is one oriented manifold component and the handles belong to it; otherwise throws InputError.
 * \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT HandleRemoval
RemoveHandles(const SurfaceMesh &                mesh,
              const SurfaceConnectivity &        connectivity,
              const std::vector<SurfaceHandle> & handles);
} // namespace shapeton

#endif
