#ifndef shapetonPouches_h
#define shapetonPouches_h

#include "shapetonTubeUnfolding.h"

namespace shapeton
{
/** Cell array with the cap number of each face, 0 on the wall. */
constexpr const char * capName = "cap";

/** Marks the faces, except caps, with an area scale below 1e-6 of the mean around all corners. Such faces are invisible
 * on the map and lost to rounding. Scale: area in the plane over area in space. \param flat the map of the surface,
 * with its faces in their order. */
std::vector<char>
InvisibleFaces(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const SurfaceMesh & flat);

/** Marks the pouches whose core contains a marked face. A pouch consists of its core and all faces connected to it with
 * an area scale below 1e-3 of the mean around all corners. The marked region can be removed as is: the rest is
 * connected with one fan at each vertex, ends are untouched, and each cap is either wholly marked or not at all. All 0
 * if nothing can be cut off. */
std::vector<char>
FacesOfPouches(const SurfaceMesh &         mesh,
               const SurfaceConnectivity & connectivity,
               const SurfaceMesh &         flat,
               const std::vector<char> &   isCore);

/** A surface after removal of its pouches. */
struct CappedSurface
{
  /** Result of ReplaceFaces(); the cell array `cap` is the cap number, 0 on the wall. */
  SurfaceMesh mesh;
  /** Remaining vertices of the original surface: vertex i of `mesh` was number keptVertices[i]. */
  std::vector<int> keptVertices;
  /** Cap number i is element i - 1. */
  std::vector<PouchCap> caps;
};

/** Cuts off the faces marked by FacesOfPouches() and closes the holes. \param caps existing caps of the surface. */
CappedSurface
CutOffPouches(const SurfaceMesh &           mesh,
              const SurfaceConnectivity &   connectivity,
              const std::vector<char> &     isPouch,
              const std::vector<PouchCap> & caps);
} // namespace shapeton

#endif
