#ifndef shapetonTubeEnds_h
#define shapetonTubeEnds_h

#include "ConformalFlatteningExport.h"

#include "shapetonRemarks.h"
#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** The boundary loops of a tube: u is 0 on the first and greatest on the second. \ingroup ConformalFlattening */
struct TubeEnds
{
  std::vector<int> first;
  std::vector<int> second;
  /** The first one is the loop that the field array `rectumLoop` names; else the one with the least vertex. */
  bool isRectumKnown{ false };

  /** All vertices of the first loop and then of the second. */
  ConformalFlattening_EXPORT std::vector<int>
                             Vertices() const;
};

/** Throws InputError, which begins with `what` and says what the surface has and which tool serves it, unless the
 * surface is one manifold, oriented component with exactly two boundary loops. Handles are allowed.
 * \ingroup ConformalFlattening */
ConformalFlattening_EXPORT TubeEnds
FindTubeEnds(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const std::string & what);

/** A tube as FindTubeEnds() needs it, whose faces look outwards, with what was changed for that in words (which name no
 * file). */
struct PreparedTube
{
  SurfaceMesh mesh;
  Remarks     warnings;
};

/** Repairs what can be repaired: coincident vertices, degenerate and duplicate faces, unreferenced vertices, faces that
 * are turned over, edges and vertices that are not manifold; turns the surface when its faces look inwards (by the
 * volume that the surface encloses with its ends closed). A sound surface is returned as it is. Vertices that
 * `rectumLoop` and `caecumLoop` name are renumbered. Throws InputError as FindTubeEnds() does.
 * \ingroup ConformalFlattening */
ConformalFlattening_EXPORT PreparedTube
PrepareTube(SurfaceMesh mesh, const std::string & what);

/** A tube without ears. \ingroup ConformalFlattening */
struct TrimmedTube
{
  SurfaceMesh mesh;
  /** What was removed. */
  int    faces{ 0 };
  double area{ 0.0 }; ///< mm^2
};

/** Removes what edges cut off that join two vertices of one end and are not of that end: for the most part ears, faces
 * with all their corners on one end. A function that is constant on the end is constant there, so no map gives them an
 * area. `rectumLoop` and `caecumLoop` lose the vertices that are gone. A tube is returned as it is where it has no such
 * edge, or would be none without what they cut off. \pre As for FindTubeEnds(). \ingroup ConformalFlattening */
ConformalFlattening_EXPORT TrimmedTube
TrimEars(SurfaceMesh mesh, const SurfaceConnectivity & connectivity);

/** Gives the field arrays `rectumLoop` and `caecumLoop` of `after` the vertices that lie where those of `before` lay;
 * arrays of which a vertex is gone are removed. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT void
RenumberLoopArrays(const SurfaceMesh & before, SurfaceMesh & after);
} // namespace shapeton

#endif
