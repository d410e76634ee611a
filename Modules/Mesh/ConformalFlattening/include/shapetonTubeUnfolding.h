#ifndef shapetonTubeUnfolding_h
#define shapetonTubeUnfolding_h

#include "shapetonConformalTube.h"

#include <functional>

namespace shapeton
{
/** A cap that closes the hole left by a blind pouch. \ingroup ShapetonConformalFlattening */
struct PouchCap
{
  /** Length of its rim (mm). */
  double neck{ 0.0 };
  /** Area of the removed wall (mm^2). */
  double area{ 0.0 };
  /** Mean of its rim vertices (LPS, mm). */
  Eigen::Vector3d place{ Eigen::Vector3d::Zero() };
};

/** A tube with a flat map without flipped faces. \ingroup ShapetonConformalFlattening */
struct UnfoldedTube
{
  /** Surface of `map`: the input, if it has no folds or no pouches. Otherwise pouches are replaced by caps. The cell
   * array `cap` is the cap number from 1, or 0 on the wall, whose faces keep their order. The point array
   * `wallPointId` is the vertex of the input surface, or -1 inside caps. */
  SurfaceMesh surface;
  TubeEnds    ends;
  /** Edge lengths of `surface` in the metric. */
  Eigen::VectorXd edgeLengths;
  TubeMap         map;
  /** Cap number i is element i - 1. */
  std::vector<PouchCap> caps;
  /** Number of times u and v were computed. */
  int solves{ 0 };
};

/** Edge lengths of a surface in the metric of a map, in edge order; reports progress.
 *
 * \ingroup ShapetonConformalFlattening */
using TubeMetric =
  std::function<Eigen::VectorXd(const SurfaceMesh &, const SurfaceConnectivity &, const Progress & progress)>;

/** Repeats FlattenTube() until the flat surface has no flipped faces (exact test, FlippedFaces()). Without folds the
 * map is bitwise identical to the result of FlattenTube(). Otherwise:
 * - blind pouches with an area scale below 1e-6 of the mean are cut off where the scale is below 1e-3, and their holes
 *   are closed by caps: their bottoms are invisible on the map and lost to rounding;
 * - edge weights at flipped faces (from the third map on, also one ring around them) are clamped to bounds that
 *   approach 1 with each map (BoundedWeights());
 * - faces still flipped after 8 maps are cut off, with the surrounding pouch where the scale is below 1e-3;
 * - finally all weights are clamped, which yields an embedding up to rounding.
 *
 * Handles always cause folds: faces within 3 rings of them are ignored, and pouches with handles are kept. If other
 * faces remain flipped, the map of the last surface with the fewest of them is returned.
 *
 * A map with the published conjugate may fold anywhere, so it is computed only once.
 *
 * \pre As for FlattenTube(); only end edges have both vertices on one end: TrimEars().
 * \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT UnfoldedTube
FlattenWithoutFolds(SurfaceMesh         mesh,
                    const TubeEnds &    ends,
                    const TubeMetric &  metric,
                    const TubeOptions & options = {});

/** Faces of caps; empty for a surface without caps. \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT std::vector<char>
                                   FacesOfCaps(const SurfaceMesh & surface);
} // namespace shapeton

#endif
