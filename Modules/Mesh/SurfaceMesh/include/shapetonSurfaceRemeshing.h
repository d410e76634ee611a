#ifndef shapetonSurfaceRemeshing_h
#define shapetonSurfaceRemeshing_h

#include "shapetonProgress.h"
#include "shapetonSurfaceMesh.h"
#include "shapetonSurfaceRemeshingOptions.h"

namespace shapeton
{
/** Options of RemeshSurface() and its progress callback. \ingroup ShapetonSurfaceMesh */
struct SurfaceRemeshingSettings : SurfaceRemeshingOptions
{
  /** Receives the completed fraction, from 0 to 1. */
  Progress progress;
};

/** Remeshes a surface with nearly equilateral triangles of uniform size.
 *
 * Botsch, Kobbelt: A remeshing approach to multiresolution modeling (2004). Edges longer than 4/3 of the target are
 * split and those shorter than 4/5 are collapsed. Flips bring the valence to six (four on a boundary). Vertices move
 * within their tangent plane toward the center of their neighbors and are projected back onto the input surface.
 * Collapses keep the link condition, so genus, components and boundary loops are preserved; no face flips over.
 * Boundary vertices do not move: boundary edges are split at their midpoint, and two are joined only if the boundary
 * between them deviates by at most 5 % of the target.
 *
 * Sharp features are rounded to about the target length. Arrays are dropped because all vertices are new; facts are
 * kept. Deterministic and single-threaded.
 *
 * Throws InputError as RequireManifold() does, and if the surface would exceed 100 million faces. Throws ParameterError
 * for options out of range. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT SurfaceMesh
RemeshSurface(const SurfaceMesh & mesh, const SurfaceRemeshingSettings & options);
} // namespace shapeton

#endif
