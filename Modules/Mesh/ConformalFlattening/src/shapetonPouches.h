#ifndef shapetonPouches_h
#define shapetonPouches_h

#include "shapetonTubeUnfolding.h"

namespace shapeton
{
/** The cell array that holds the number of the cap of a face, 0 on the wall. */
constexpr const char * capName = "cap";

/** Marks the faces, caps left out, around all of whose corners the area scale is below 1e-6 of the mean: nobody sees
 * them on the map, and their places drown in rounding. Scale: area in the plane over area in space. \param flat the map
 * of the surface, with its faces in their order. */
std::vector<char>
InvisibleFaces(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const SurfaceMesh & flat);

/** Marks the pouches with a marked face in their core: the faces around all of whose corners the area scale is below
 * 1e-3 of the mean and that are joined to the core, and the core itself. They can be cut off as they are: the rest is
 * connected, at each vertex it is one fan, and no end is touched; caps are whole in a pouch or not at all. All 0 where
 * nothing can be cut off. */
std::vector<char>
FacesOfPouches(const SurfaceMesh &         mesh,
               const SurfaceConnectivity & connectivity,
               const SurfaceMesh &         flat,
               const std::vector<char> &   isCore);

/** A surface whose pouches were cut off. */
struct CappedSurface
{
  /** As ReplaceFaces() gives it; the cell array `cap` has the number of the cap, 0 on the wall. */
  SurfaceMesh mesh;
  /** The vertices of the surface before that are left: vertex i of `mesh` was number keptVertices[i]. */
  std::vector<int> keptVertices;
  /** Number i is element i - 1. */
  std::vector<PouchCap> caps;
};

/** Cuts off the faces that FacesOfPouches() marks and closes the holes. \param caps those that the surface has. */
CappedSurface
CutOffPouches(const SurfaceMesh &           mesh,
              const SurfaceConnectivity &   connectivity,
              const std::vector<char> &     isPouch,
              const std::vector<PouchCap> & caps);
} // namespace shapeton

#endif
