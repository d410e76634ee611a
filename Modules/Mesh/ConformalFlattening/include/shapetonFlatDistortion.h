#ifndef shapetonFlatDistortion_h
#define shapetonFlatDistortion_h

#include "shapetonFlatSurface.h"
#include "shapetonSurfaceLaplacian.h"

namespace shapeton
{
/** Side lengths, one face per row: side k runs from corner k to the next one. \ingroup ShapetonConformalFlattening */
using SideLengths = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/** \defgroup FlatDistortion How a map to the plane distorts the faces of a surface, in any metric on it
 * A cut preserves the faces, so the side lengths of the surface also apply to the cut surface.
 * \ingroup ShapetonConformalFlattening */
///@{

/** Sides of all faces from edge lengths in any metric, such as HeatDiffusionMetric::edgeLengths. */
ShapetonConformalFlattening_EXPORT SideLengths
SidesOfFaces(const SurfaceConnectivity & connectivity, const Eigen::VectorXd & edgeLengths);

/** Straight side lengths in space (mm). */
ShapetonConformalFlattening_EXPORT SideLengths
SidesOfFaces(const VertexMatrix & V, const FaceMatrix & F);

/** Distortion of each face under the affine map to the plane. */
struct FlatDistortion
{
  /** Quasi-conformal dilatation K >= 1, the ratio of the singular values; 1 for a conformal map. Infinite if the face
   * has no area in the plane or in the metric. Independent of the orientation of the face. */
  Eigen::VectorXd dilatation;
  /** Area in the plane over area in the metric; also positive for flipped faces. */
  Eigen::VectorXd areaScale;
  /** FlippedFaces(). */
  std::vector<char> isFlipped;
  int               flips{ 0 };
  /** Whether faces covering most of the flat area are clockwise, as in the view from inside. */
  bool isClockwise{ false };
};

/** K + 1/K = sum_k cot(angle_k) l'_k^2 / (2 A'), with the angles in the metric, and lengths l' and area A' in the
 * plane. \pre `uv` has a row for each vertex in F, `sides` one for each face; otherwise throws InputError. */
ShapetonConformalFlattening_EXPORT FlatDistortion
MeasureFlatDistortion(const FaceMatrix & F, const Eigen::MatrixX2d & uv, const SideLengths & sides);

/** Marks the faces with zero area in the plane, or with an orientation opposite to most of the flat area. Uses exact
 * arithmetic (ExactOrientation()). No face is marked if the map is locally one-to-one. */
ShapetonConformalFlattening_EXPORT std::vector<char>
                                   FlippedFaces(const FaceMatrix & F, const Eigen::MatrixX2d & uv);

/** Plane coordinates of face corners; corner k of a face is row 3 * face + k. */
using CornerPlaces = Eigen::MatrixX2d;

/** Corners of a flat surface. */
ShapetonConformalFlattening_EXPORT CornerPlaces
PlacesOfCorners(const FaceMatrix & F, const Eigen::MatrixX2d & uv);

/** Angle defect of each vertex of the surface before the cut, in radians: 2 pi minus the plane angles of its faces.
 * Zero up to rounding where the map is locally one-to-one; boundary vertices are set to zero. The faces around a
 * vertex may be in different periods of the map. */
ShapetonConformalFlattening_EXPORT Eigen::VectorXd
FlatAngleDefects(const FaceMatrix & F, const SurfaceConnectivity & connectivity, const CornerPlaces & places);

/** Summary statistics of a set of values. */
struct DistortionQuantiles
{
  double median{ 0.0 };
  double p95{ 0.0 };
  double p99{ 0.0 };
  int    number{ 0 };
};

/** Quantiles of the dilatation over the unflipped faces, unweighted by area. Faces marked in `leftOut` are skipped. The
 * p-quantile of n sorted values is the one with the zero-based index floor(p n). All are 0 if no face remains. */
ShapetonConformalFlattening_EXPORT DistortionQuantiles
QuantilesOfDilatation(const FlatDistortion & distortion, const std::vector<char> & leftOut = {});

/** Triangle shapes in a metric (5.2.1). */
struct TriangleQuality
{
  /** Histogram of faces by 2r/R, twice the inscribed radius divided by the circumscribed radius, in equal bins of [0,
   * 1]: 1 is equilateral, 0 a needle. The last bin includes 1. (The dissertation's R/2r is at least 1; its threshold of
   * 0.6 applies to the reciprocal.) */
  std::vector<int> histogram;
  double           mean{ 0.0 };
  /** Fraction of faces below 0.6. */
  double shareBelowThreshold{ 0.0 };
};

/** 2r/R of each face; 0 if the sides do not form a triangle. */
ShapetonConformalFlattening_EXPORT Eigen::VectorXd
                                   TriangleQualities(const SideLengths & sides);

/** Histogram with the given number of bins, at least 1. */
ShapetonConformalFlattening_EXPORT TriangleQuality
MeasureTriangleQuality(const SideLengths & sides, int bins = 20);
///@}
} // namespace shapeton

#endif
