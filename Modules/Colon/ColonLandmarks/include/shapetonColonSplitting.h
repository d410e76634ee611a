#ifndef shapetonColonSplitting_h
#define shapetonColonSplitting_h

#include "shapetonRemarks.h"
#include "shapetonColonLandmarks.h"

namespace shapeton
{
/** A segment of the colon, cut open along a taenia and flattened separately. \ingroup ShapetonColonLandmarks */
struct ColonPiece
{
  /** Segment number as in ColonSegments. */
  int         segment{ 0 };
  std::string name;
  /** Surface with `uv` (mm): a rectangle from (0, 0) with u starting at the rectal end; the taenia forms both sides v =
   * const. The field array CutCorners keeps the cut in files. See ConformalMap::flat. */
  SurfaceMesh flat;
  /** Lower and upper bounds on the ratio of height to width of the rectangle (dissertation 4.3, Figure 4.6). */
  double modulusU{ 0.0 };
  double modulusV{ 0.0 };
  /** Size of the rectangle, mm; its area equals the surface area. */
  double width{ 0.0 };
  double height{ 0.0 };
  /** Wall area, mm^2. */
  double area{ 0.0 };
  /** Number of flipped faces. */
  int flips{ 0 };
};

/** The segments of a colon as separate surfaces, cut along a taenia and mapped to rectangles. See SplitColon().
 * \ingroup ShapetonColonLandmarks */
struct ColonPieces
{
  std::vector<ColonPiece> pieces;
  Remarks                 warnings;
};

/** Cuts the wall at the segment borders, cuts each segment along the first taenia, and maps it to a rectangle with
 * MapConformally(). Skips, with a warning, each segment that is unknown or not a tube between its borders. Skips all
 * segments if there are no taeniae. \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT ColonPieces
SplitColon(const SurfaceMesh & flat, const ColonLandmarks & landmarks, const Progress & progress = {});

/** A list of objects with the keys segment, name, modulus (the geometric mean), modulusU, modulusV, width, height,
 * area, faces, flips.
 * \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT Json
ColonPiecesToJson(const ColonPieces & pieces);
} // namespace shapeton

#endif
