#ifndef shapetonTubeEnds_h
#define shapetonTubeEnds_h

#include "ShapetonConformalFlatteningExport.h"

#include "shapetonRemarks.h"
#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** Boundary loops of a tube: u is 0 on the first and largest on the second. \ingroup ShapetonConformalFlattening */
struct TubeEnds
{
  std::vector<int> first;
  std::vector<int> second;
  /** The first loop is given by the field array `rectumLoop`; otherwise it is the loop with the lowest vertex index. */
  bool isRectumKnown{ false };

  /** All vertices of the first loop, then of the second. */
  ShapetonConformalFlattening_EXPORT std::vector<int>
                                     Vertices() const;
};

/** Throws InputError unless the surface is one oriented manifold component with exactly two boundary loops. Handles are
 * allowed. The message starts with `what`, describes the surface and states the tool to use.
 * \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT TubeEnds
FindTubeEnds(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const std::string & what);

/** A tube prepared for FindTubeEnds(), with faces oriented outward, and a description of each repair (without file
 * names). */
struct PreparedTube
{
  SurfaceMesh mesh;
  Remarks     warnings;
};

/** Repairs coincident vertices, degenerate and duplicate faces, unreferenced vertices, flipped faces, and non-manifold
 * edges and vertices. Flips all faces if they point inward, that is, if the volume enclosed with closed ends is
 * negative. A sound surface is returned unchanged. Vertices in `rectumLoop` and `cecumLoop` are renumbered. Throws
 * InputError as FindTubeEnds() does. \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT PreparedTube
PrepareTube(SurfaceMesh mesh, const std::string & what);

/** A tube without ears. \ingroup ShapetonConformalFlattening */
struct TrimmedTube
{
  SurfaceMesh mesh;
  /** Number of removed faces. */
  int    faces{ 0 };
  double area{ 0.0 }; ///< mm^2
};

/** Removes parts cut off by interior edges that join two vertices of one end. These are mostly ears: faces with all
 * corners on one end, which collapse in any map that is constant on each end. Removed vertices are dropped from
 * `rectumLoop` and `cecumLoop`. The tube is returned unchanged if no edge is found, or if the result would not be a
 * tube. \pre As for FindTubeEnds(). \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT TrimmedTube
TrimEars(SurfaceMesh mesh, const SurfaceConnectivity & connectivity);

/** Updates the field arrays `rectumLoop` and `cecumLoop` of `after`, matching its vertices with those of `before` by
 * position. An array with a missing vertex is removed. \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT void
RenumberLoopArrays(const SurfaceMesh & before, SurfaceMesh & after);
} // namespace shapeton

#endif
