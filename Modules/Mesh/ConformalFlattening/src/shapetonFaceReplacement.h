#ifndef shapetonFaceReplacement_h
#define shapetonFaceReplacement_h

#include "shapetonHoleFilling.h"

#include <string>

namespace shapeton
{
/** A surface with some faces replaced by hole fillings. */
struct FaceReplacement
{
  /** The remaining faces in their order, then the fillings. Point arrays of new vertices are means over the
   * rim of the hole; cell arrays of new faces are 0, the mark array is 1. `rectumLoop` and `cecumLoop` are
   * renumbered. */
  SurfaceMesh mesh;
  /** Remaining vertices of the original surface, ascending: vertex i of `mesh` was number keptVertices[i]. */
  std::vector<int>         keptVertices;
  std::vector<HoleFilling> fillings;
};

/** Cell array with 1 on the fillings of removed handles. */
constexpr const char * filledName = "filled";

/** Closes boundary loops with triangles as large as those around them (TriangulateHole(), SmoothFilling()). New faces
 * and vertices are appended, with arrays as in FaceReplacement. \param connectivity of the surface with these loops.
 * \param markName integer cell array that marks new faces; created if missing.
 * Throws InputError if the result is not one oriented manifold component. */
std::vector<HoleFilling>
FillHoles(SurfaceMesh &                         mesh,
          const SurfaceConnectivity &           connectivity,
          const std::vector<std::vector<int>> & loops,
          const std::string &                   markName);

int
NumberOfFilledFaces(const std::vector<HoleFilling> & fillings);

/** Deletes additional faces until each interior vertex has a single fan. */
void
OpenPinches(const FaceMatrix & F, const SurfaceConnectivity & connectivity, std::vector<char> & isDeleted);

/** Deletes faces, and everything this disconnects from the largest part, and fills the holes
 * (FillHoles()). Boundaries are unchanged.
 * \param isDeleted for each face; after OpenPinches().
 * \param markName integer cell array that marks new faces; created if missing.
 * \pre The surface is one oriented manifold component. Throws InputError if the result is not. */
FaceReplacement
ReplaceFaces(const SurfaceMesh &         mesh,
             const SurfaceConnectivity & connectivity,
             const std::vector<char> &   isDeleted,
             const std::string &         markName);
} // namespace shapeton

#endif
