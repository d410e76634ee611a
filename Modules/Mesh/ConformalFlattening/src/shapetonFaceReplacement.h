#ifndef shapetonFaceReplacement_h
#define shapetonFaceReplacement_h

#include "shapetonHoleFilling.h"

#include <string>

namespace shapeton
{
/** A surface of which some faces were replaced by fillings of the holes that they leave. */
struct FaceReplacement
{
  /** The faces that are left in their order, then those of the fillings. Point arrays of new vertices are means over
   * the rim of the hole; cell arrays of new faces are 0, and that of the mark is 1. `rectumLoop` and `caecumLoop` are
   * renumbered. */
  SurfaceMesh mesh;
  /** The vertices of the surface before that are left, ascending: vertex i of `mesh` was number keptVertices[i]. */
  std::vector<int>         keptVertices;
  std::vector<HoleFilling> fillings;
};

/** Deletes further faces until at each vertex inside the rest is one fan. */
void
OpenPinches(const FaceMatrix & F, const SurfaceConnectivity & connectivity, std::vector<char> & isDeleted);

/** Deletes faces, and what that cuts off from the greatest part, and fills the holes with triangles of the size of
 * those around them (TriangulateHole(), SmoothFilling()). Boundaries stay as they are.
 *
 * \param isDeleted for each face; after OpenPinches().
 * \param markName a cell array of whole numbers that marks new faces; it is added where there is none.
 * \pre The surface is one manifold, oriented component; InputError where the result is not. */
FaceReplacement
ReplaceFaces(const SurfaceMesh &         mesh,
             const SurfaceConnectivity & connectivity,
             const std::vector<char> &   isDeleted,
             const std::string &         markName);
} // namespace shapeton

#endif
