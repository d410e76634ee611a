#ifndef shapetonSurfaceRemeshing_h
#define shapetonSurfaceRemeshing_h

#include "shapetonProgress.h"
#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Edge length and rounds for RemeshSurface(). \ingroup SurfaceMesh */
struct SurfaceRemeshingOptions
{
  /** Length that edges shall have, mm, greater than 0. */
  double targetEdgeLength{ 1.0 };
  /** Rounds of splitting, collapsing, flipping and smoothing, from 1 to 100. */
  int iterations{ 8 };
  /** Told the share that is done, from 0 to 1. */
  Progress progress;
};

/** A surface of nearly equilateral triangles of one size.
 *
 * Botsch, Kobbelt: A remeshing approach to multiresolution modeling (2004): edges longer than 4/3 of the target are
 * split, those shorter than 4/5 collapsed, edges are flipped so that vertices have six edges (four on a boundary),
 * vertices move within their tangent plane towards the centre of their neighbours and back onto the given surface.
 * Collapses keep the link condition, so genus, components and boundary loops stay; no face turns over. Vertices of
 * boundaries do not move: boundary edges are split at their middle, and two are joined only where the boundary between
 * them deviates by at most 5 % of the target.
 *
 * Features such as sharp edges are rounded to about the target length. Arrays are left out, since the vertices are new
 * ones; facts are kept. Equal input gives equal output; one thread.
 *
 * Throws InputError as RequireManifold() does, and when the surface would get more than 100 million faces;
 * ParameterError for options out of range. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT SurfaceMesh
RemeshSurface(const SurfaceMesh & mesh, const SurfaceRemeshingOptions & options);
} // namespace shapeton

#endif
