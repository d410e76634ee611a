#ifndef shapetonSurfaceHandles_h
#define shapetonSurfaceHandles_h

#include "shapetonFlatDistortion.h"

namespace shapeton
{
/** A place where a flattened surface has handles. \ingroup ConformalFlattening */
struct SurfaceHandle
{
  /** How many handles: more than 1 where several are too close to be told apart. */
  int genus{ 0 };
  /** The mean of its vertices; LPS, mm. */
  Eigen::Vector3d place{ Eigen::Vector3d::Zero() };
  /** The mean place of its faces in the plane. */
  Eigen::Vector2d flatPlace{ Eigen::Vector2d::Zero() };
  /** The greatest distance of its vertices from `place`, mm. */
  double radius{ 0.0 };
  /** Its vertices on the surface that was flattened, one ring around the singular ones included; ascending. */
  std::vector<int> vertices;
};

/** The handles of a flat tube and what was taken for one by mistake. See DetectHandles().
 * \ingroup ConformalFlattening */
struct HandleDetection
{
  /** In the order of their first vertices. */
  std::vector<SurfaceHandle> handles;
  /** Clusters of singular vertices without a handle. */
  int falseAlarms{ 0 };
  /** The sum over the handles. */
  int genus{ 0 };
};

/** Finds the handles of a surface from its flat map (dissertation 5.4.3).
 *
 * A flat map has no angle defect but where it is folded, and it must be folded at handles. Vertices with a defect of
 * more than 1e-6, with one ring around them, fall into clusters. By Gauss and Bonnet the defects of a cluster sum to
 * -4 pi times its genus; clusters with sum 0 are false alarms. The map needs to be right elsewhere: that of
 * FlattenTube() with the Laplacian, in any metric.
 *
 * \param connectivity of the surface before it was cut.
 * \param flat the flat surface, whose faces are those in their order.
 * Throws InputError where `flat` is no flat surface of that one. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT HandleDetection
DetectHandles(const SurfaceConnectivity & connectivity, const SurfaceMesh & flat);

/** Marks the faces with a corner at most so many edges away from a vertex of a handle. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT std::vector<char>
FacesNearHandles(const SurfaceConnectivity & connectivity, const std::vector<SurfaceHandle> & handles, int rings);
/** A surface without the handles that were cut out. \ingroup ConformalFlattening */
struct HandleRemoval
{
  /** Point arrays of new vertices are means over the rim of the hole; cell arrays of new faces are 0, and the cell
   * array `filled` is 1 there. `rectumLoop` and `caecumLoop` are renumbered. */
  SurfaceMesh mesh;
  int         removedFaces{ 0 };
  int         filledHoles{ 0 };
  int         filledFaces{ 0 };
  /** Of the handles that are left: those next to a boundary are not touched. */
  int genus{ 0 };
};

/** Deletes the vertices of the handles with their faces, and what that cuts off, and fills the holes with triangles of
 * the size of those around them (Liepa, Filling holes in meshes, 2003), laid so that the surface bends least: the
 * squares of the uniform Laplacian at new vertices and at the rim sum to a minimum. Boundaries stay as they are.
 *
 * \pre The surface is one manifold, oriented component, the handles are of it; else InputError.
 * \ingroup ConformalFlattening */
ConformalFlattening_EXPORT HandleRemoval
RemoveHandles(const SurfaceMesh &                mesh,
              const SurfaceConnectivity &        connectivity,
              const std::vector<SurfaceHandle> & handles);
} // namespace shapeton

#endif
