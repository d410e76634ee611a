#ifndef shapetonColonSplitting_h
#define shapetonColonSplitting_h

#include "shapetonRemarks.h"
#include "shapetonColonLandmarks.h"

namespace shapeton
{
/** A segment of the colon, cut open along a taenia and flattened on its own. \ingroup ColonLandmarks */
struct ColonPiece
{
  /** As ColonSegments. */
  int         segment{ 0 };
  std::string name;
  /** In space, with `uv` (mm): a rectangle from (0, 0) on, u from the rectal end on, both sides along v = const are the
   * taenia. As ConformalMap::flat. */
  SurfaceMesh flat;
  /** Height over width of the rectangle (dissertation 4.3, Figure 4.6): not less and not greater than the true one. */
  double modulusU{ 0.0 };
  double modulusV{ 0.0 };
  /** mm of the rectangle, which has the area of the surface. */
  double width{ 0.0 };
  double height{ 0.0 };
  /** mm^2. */
  double area{ 0.0 };
  /** Faces that the map turns over. */
  int flips{ 0 };
};

/** The segments of a colon as surfaces of their own, cut along a taenia and mapped to rectangles. See SplitColon().
 * \ingroup ColonLandmarks */
struct ColonPieces
{
  std::vector<ColonPiece> pieces;
  Remarks                 warnings;
};

/** Cuts the wall at the borders of its segments and each segment along the first taenia, and maps each to a rectangle
 * with MapConformally(). A segment that is not known, or is no tube between its borders, is left out with a warning, as
 * all are where there is no taenia. \ingroup ColonLandmarks */
ColonLandmarks_EXPORT ColonPieces
SplitColon(const SurfaceMesh & flat, const ColonLandmarks & landmarks, const Progress & progress = {});

/** A list of segment, name, modulus (the geometric mean), modulusU, modulusV, width, height, area, faces, flips.
 * \ingroup ColonLandmarks */
ColonLandmarks_EXPORT Json
ColonPiecesToJson(const ColonPieces & pieces);
} // namespace shapeton

#endif
