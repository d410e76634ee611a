#ifndef shapetonSurfaceSimplification_h
#define shapetonSurfaceSimplification_h

#include "shapetonProgress.h"
#include "shapetonSurfaceMesh.h"
#include "shapetonSurfaceSimplificationOptions.h"

namespace shapeton
{
/** Options of SimplifySurface() and its progress callback. \ingroup ShapetonSurfaceMesh */
struct SurfaceSimplificationSettings : SurfaceSimplificationOptions
{
  /** Receives the completed fraction, from 0 to 1. */
  Progress progress;
};

/** Report of SimplifySurface(). \ingroup ShapetonSurfaceMesh */
struct SurfaceSimplificationReport
{
  int facesBefore{ 0 };
  int faces{ 0 };
  int collapses{ 0 };
  /** Whether at most the target number of faces remains. */
  bool reachedTarget{ false };
  /** Final angle limit (degrees). */
  double smallestAngle{ 0.0 };
  /** Reason why the target was not reached; empty otherwise. */
  std::string reason;
};

/** Simplifies a surface by edge collapses with the quadric error metric.
 *
 * Each vertex stores the sum of squared distances to the planes of its faces, weighted by area (Garland, Heckbert:
 * Surface simplification using quadric error metrics, 1997), and to planes through boundary edges, perpendicular to
 * their face. The squared distance to the old vertex is added with weight 1/1000, which keeps positions well defined in
 * flat regions. The cheapest edge is collapsed to its point of least error. A collapse requires that
 * - the link condition holds: manifoldness, genus, components and boundary loops are preserved;
 * - no face normal turns by more than about 70 degrees;
 * - no angle becomes smaller than the limit.
 * A boundary vertex merged with an interior one keeps its position. Deterministic: ties are broken by vertex indices.
 * Single-threaded; about 4 microseconds and 250 bytes per face.
 *
 * Remaining vertices and faces keep their order. Arrays are dropped because the vertices are new; facts are kept. A
 * surface that already has few enough faces is returned with its arrays.
 *
 * Throws InputError as RequireManifold() does, and ParameterError for options out of range.
 * \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT SurfaceMesh
SimplifySurface(const SurfaceMesh &                   mesh,
                const SurfaceSimplificationSettings & options,
                SurfaceSimplificationReport *         report = nullptr);
} // namespace shapeton

#endif
