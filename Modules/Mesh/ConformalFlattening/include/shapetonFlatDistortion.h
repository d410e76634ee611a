#ifndef shapetonFlatDistortion_h
#define shapetonFlatDistortion_h

#include "shapetonFlatSurface.h"
#include "shapetonSurfaceLaplacian.h"

namespace shapeton
{
/** Lengths of the sides of faces, one face in each row: side k runs from corner k to the next one.
 * \ingroup ConformalFlattening */
using SideLengths = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/** \defgroup FlatDistortion How a map to the plane distorts the faces of a surface, in any metric on it
 * Cutting a surface keeps its faces, so lengths of sides of the surface serve for the cut one.
 * \ingroup ConformalFlattening */
///@{

/** The sides of all faces from the lengths of the edges in any metric, such as HeatDiffusionMetric::edgeLengths. */
ConformalFlattening_EXPORT SideLengths
SidesOfFaces(const SurfaceConnectivity & connectivity, const Eigen::VectorXd & edgeLengths);

/** The straight sides in space; mm. */
ConformalFlattening_EXPORT SideLengths
SidesOfFaces(const VertexMatrix & V, const FaceMatrix & F);

/** The distortion of each face by the affine map that takes it to the plane. */
struct FlatDistortion
{
  /** The quasi-conformal dilatation K >= 1, the ratio of the singular values: 1 where the map is conformal. Infinite
   * where the face has no area in the plane or in the metric. It does not tell whether the face is flipped. */
  Eigen::VectorXd dilatation;
  /** Area in the plane over area in the metric, positive also for flipped faces. */
  Eigen::VectorXd areaScale;
  /** FlippedFaces(). */
  std::vector<char> isFlipped;
  int               flips{ 0 };
  /** Faces of most of the flat area are clockwise, as in the view from inside. */
  bool isClockwise{ false };
};

/** K + 1/K = sum_k cot(angle_k) l'_k^2 / (2 A'), with the angles in the metric, lengths l' and area A' in the plane.
 * \pre `uv` has a row for each vertex that F names, `sides` one for each face; else InputError. */
ConformalFlattening_EXPORT FlatDistortion
MeasureFlatDistortion(const FaceMatrix & F, const Eigen::MatrixX2d & uv, const SideLengths & sides);

/** Marks the faces that have no area in the plane, or whose orientation there is not that of most of the flat area: by
 * the places as they are, without rounding (ExactOrientation()). None is marked where the map is locally one to one. */
ConformalFlattening_EXPORT std::vector<char>
                           FlippedFaces(const FaceMatrix & F, const Eigen::MatrixX2d & uv);

/** Places in the plane of the corners of faces, corner k of a face in row 3 * face + k. */
using CornerPlaces = Eigen::MatrixX2d;

/** Of the corners of a flat surface. */
ConformalFlattening_EXPORT CornerPlaces
PlacesOfCorners(const FaceMatrix & F, const Eigen::MatrixX2d & uv);

/** For each vertex of the surface before it was cut 2 pi minus the angles that its faces have there in the plane,
 * radians: 0 but for rounding where the map is locally one to one, and on the boundaries, which are left out. The faces
 * around a vertex may lie in different periods of the map. */
ConformalFlattening_EXPORT Eigen::VectorXd
FlatAngleDefects(const FaceMatrix & F, const SurfaceConnectivity & connectivity, const CornerPlaces & places);

/** What one wants to know of many values. */
struct DistortionQuantiles
{
  double median{ 0.0 };
  double p95{ 0.0 };
  double p99{ 0.0 };
  int    number{ 0 };
};

/** Quantiles of the dilatation over the faces that are not flipped, each face counting once whatever its area; with
 * `leftOut` also without the faces marked there. The p-quantile of n sorted values is number floor(p n). 0 where no
 * face is left. */
ConformalFlattening_EXPORT DistortionQuantiles
QuantilesOfDilatation(const FlatDistortion & distortion, const std::vector<char> & leftOut = {});

/** The shapes of the triangles of a metric (5.2.1). */
struct TriangleQuality
{
  /** Number of faces by 2r/R, twice the inscribed over the circumscribed radius, in equal parts of [0, 1]: 1 is
   * equilateral, 0 a needle. The last part includes 1. (The ratio R/2r of the text is at least 1; its threshold of 0.6
   * belongs to the reciprocal.) */
  std::vector<int> histogram;
  double           mean{ 0.0 };
  /** The part of the faces below 0.6. */
  double shareBelowThreshold{ 0.0 };
};

/** 2r/R of each face; 0 where the sides form no triangle. */
ConformalFlattening_EXPORT Eigen::VectorXd
                           TriangleQualities(const SideLengths & sides);

/** Their histogram with so many parts, at least 1. */
ConformalFlattening_EXPORT TriangleQuality
MeasureTriangleQuality(const SideLengths & sides, int bins = 20);
///@}
} // namespace shapeton

#endif
