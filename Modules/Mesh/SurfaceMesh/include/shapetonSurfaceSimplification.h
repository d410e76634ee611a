#ifndef shapetonSurfaceSimplification_h
#define shapetonSurfaceSimplification_h

#include "shapetonProgress.h"
#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Number of faces and shape of triangles for SimplifySurface(). \ingroup SurfaceMesh */
struct SurfaceSimplificationOptions
{
  /** How many faces to end with, from 1; no more than one is missing where the topology allows so few. */
  int targetFaces{ 50000 };
  /** No collapse makes a smaller angle than this (degrees, 0 to 30), except where one as small was there before.
   * Lowered by steps of 5 degrees to 0 as long as the target is out of reach otherwise. */
  double smallestAngle{ 20.0 };
  /** Weight of boundary edges against faces, from 0. Large values keep the shape of boundaries. */
  double boundaryWeight{ 10.0 };
  /** Told the share that is done, from 0 to 1, now and then. */
  Progress progress;
};

/** What SimplifySurface() did, and why it ended. \ingroup SurfaceMesh */
struct SurfaceSimplificationReport
{
  int facesBefore{ 0 };
  int faces{ 0 };
  int collapses{ 0 };
  /** At most targetFaces are left. */
  bool reachedTarget{ false };
  /** The last limit of angles that was needed, degrees. */
  double smallestAngle{ 0.0 };
  /** Why the target was not reached; empty otherwise. */
  std::string reason;
};

/** A surface of fewer faces, by edge collapses with the quadric error metric.
 *
 * Each vertex keeps the sum of squared distances to the planes of its faces, weighted by area (Garland, Heckbert:
 * Surface simplification using quadric error metrics, 1997), and to planes through boundary edges, perpendicular to
 * their face; a thousandth part of the distance to the old vertex itself keeps positions definite in flat parts. The
 * edge that costs least is collapsed into the point of least error. A collapse happens only when
 * - the link condition holds: manifoldness, genus, components and boundary loops never change,
 * - no face turns by more than about 70 degrees,
 * - no angle becomes smaller than the limit.
 * A vertex of a boundary that merges with one inside stays where it is. Ties are broken by the indices of the vertices;
 * equal input gives equal output. One thread; about 4 microseconds for each face and 250 bytes of memory.
 *
 * Vertices and faces keep their order as far as they remain. The arrays of the surface are left out, since the vertices
 * are new ones; facts are kept. A surface with no more faces than asked for is returned with its arrays.
 *
 * Throws InputError as RequireManifold() does; ParameterError for options out of range.
 * \ingroup SurfaceMesh */
SurfaceMesh_EXPORT SurfaceMesh
SimplifySurface(const SurfaceMesh &                  mesh,
                const SurfaceSimplificationOptions & options,
                SurfaceSimplificationReport *        report = nullptr);
} // namespace shapeton

#endif
