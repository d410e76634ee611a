#ifndef shapetonSurfaceSmoothing_h
#define shapetonSurfaceSmoothing_h

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Limits on the motion of vertices during smoothing. See SmoothSurface(). \ingroup ShapetonSurfaceMesh */
struct SurfaceSmoothingOptions
{
  /** Number of pairs of shrinking and inflating steps (Taubin: A signal processing approach to fair surface design,
   * 1995), at least 0. */
  int iterations{ 10 };
  /** Maximum displacement of a vertex along its normal, mm, at least 0. */
  double normalLimit{ 0.15 };
  /** Maximum displacement along the surface, mm, at least 0. */
  double tangentialLimit{ 0.5 };
};

/** Moves vertices to improve triangle shape and flatten stairs. Boundary vertices, faces and arrays are unchanged. The
 * result does not depend on the number of threads. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT SurfaceMesh
SmoothSurface(const SurfaceMesh & mesh, const SurfaceSmoothingOptions & options);
} // namespace shapeton

#endif
