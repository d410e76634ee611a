#include "shapetonFlatDistortion.h"

#include "shapetonExactOrientation.h"
#include "shapetonExceptions.h"
#include "shapetonPi.h"
#include "shapetonQuantiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
constexpr double qualityThreshold = 0.6; // of 2r/R; the threshold of the dissertation, see TriangleQuality

/** 16 times the squared area in Kahan's ordering, which is accurate for needles; 0 if the sides do not form a triangle.
 */
double
HeronProduct(double x, double y, double z)
{
  const double longest = std::max({ x, y, z });
  const double shortest = std::min({ x, y, z });
  const double middle = std::max(std::min(x, y), std::min(std::max(x, y), z));
  return std::max(0.0,
                  (longest + (middle + shortest)) * (shortest - (longest - middle)) * (shortest + (longest - middle)) *
                    (longest + (middle - shortest)));
}

double
AreaOf(const SideLengths & sides, Eigen::Index face)
{
  return 0.25 * std::sqrt(HeronProduct(sides(face, 0), sides(face, 1), sides(face, 2)));
}

double
SignedFlatArea(const FaceMatrix & F, const Eigen::MatrixX2d & uv, Eigen::Index face)
{
  const Eigen::RowVector2d a = uv.row(F(face, 1)) - uv.row(F(face, 0));
  const Eigen::RowVector2d b = uv.row(F(face, 2)) - uv.row(F(face, 0));
  return 0.5 * (a[0] * b[1] - a[1] * b[0]);
}

/** K of a face with this area in the metric and in the plane. */
double
Dilatation(const FaceMatrix &       F,
           const Eigen::MatrixX2d & uv,
           const SideLengths &      sides,
           Eigen::Index             face,
           double                   area,
           double                   flatArea)
{
  if (!(area > 0.0) || !(flatArea > 0.0))
  {
    return std::numeric_limits<double>::infinity();
  }
  double sum = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const int    next = (k + 1) % 3;
    const int    last = (k + 2) % 3;
    const double here = sides(face, k) * sides(face, k);
    const double others = sides(face, next) * sides(face, next) + sides(face, last) * sides(face, last);
    const double cotangent = (others - here) / (4.0 * area);
    sum += cotangent * (uv.row(F(face, next)) - uv.row(F(face, k))).squaredNorm();
  }
  const double half = std::max(1.0, sum / (4.0 * flatArea));
  return half + std::sqrt(half * half - 1.0);
}
} // namespace

SideLengths
SidesOfFaces(const SurfaceConnectivity & connectivity, const Eigen::VectorXd & edgeLengths)
{
  if (edgeLengths.size() != connectivity.NumberOfEdges())
  {
    throw InputError("there are " + std::to_string(edgeLengths.size()) + " lengths for " +
                     std::to_string(connectivity.NumberOfEdges()) + " edges");
  }
  SideLengths sides(connectivity.NumberOfFaces(), 3);
  for (int face = 0; face < connectivity.NumberOfFaces(); ++face)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int edge = connectivity.EdgeOfFace(face, k);
      sides(face, k) = edge == -1 ? 0.0 : edgeLengths[edge];
    }
  }
  return sides;
}

SideLengths
SidesOfFaces(const VertexMatrix & V, const FaceMatrix & F)
{
  SideLengths sides(F.rows(), 3);
  for (Eigen::Index face = 0; face < F.rows(); ++face)
  {
    for (int k = 0; k < 3; ++k)
    {
      sides(face, k) = (V.row(F(face, (k + 1) % 3)) - V.row(F(face, k))).norm();
    }
  }
  return sides;
}

FlatDistortion
MeasureFlatDistortion(const FaceMatrix & F, const Eigen::MatrixX2d & uv, const SideLengths & sides)
{
  if (sides.rows() != F.rows() || (F.size() > 0 && F.maxCoeff() >= uv.rows()))
  {
    throw InputError("the flat map does not match the surface: " + std::to_string(uv.rows()) + " places, sides of " +
                     std::to_string(sides.rows()) + " of " + std::to_string(F.rows()) + " faces");
  }
  FlatDistortion  distortion{ Eigen::VectorXd(F.rows()), Eigen::VectorXd(F.rows()), {} };
  Eigen::VectorXd signedAreas(F.rows());
  for (Eigen::Index face = 0; face < F.rows(); ++face)
  {
    signedAreas[face] = SignedFlatArea(F, uv, face);
    const double area = AreaOf(sides, face);
    const double flatArea = std::abs(signedAreas[face]);
    distortion.areaScale[face] = area > 0.0 ? flatArea / area : std::numeric_limits<double>::infinity();
    distortion.dilatation[face] = Dilatation(F, uv, sides, face, area, flatArea);
  }
  distortion.isClockwise = signedAreas.sum() < 0.0;
  distortion.isFlipped = FlippedFaces(F, uv);
  distortion.flips = static_cast<int>(std::count(distortion.isFlipped.begin(), distortion.isFlipped.end(), 1));
  return distortion;
}

std::vector<char>
FlippedFaces(const FaceMatrix & F, const Eigen::MatrixX2d & uv)
{
  double area = 0.0;
  for (Eigen::Index face = 0; face < F.rows(); ++face)
  {
    area += SignedFlatArea(F, uv, face);
  }
  const int         sign = area < 0.0 ? -1 : 1;
  std::vector<char> isFlipped(static_cast<std::size_t>(F.rows()));
  for (Eigen::Index face = 0; face < F.rows(); ++face)
  {
    isFlipped[face] = ExactOrientation(uv.row(F(face, 0)), uv.row(F(face, 1)), uv.row(F(face, 2))) != sign;
  }
  return isFlipped;
}

CornerPlaces
PlacesOfCorners(const FaceMatrix & F, const Eigen::MatrixX2d & uv)
{
  CornerPlaces places(F.size(), 2);
  for (Eigen::Index corner = 0; corner < F.size(); ++corner)
  {
    places.row(corner) = uv.row(F.data()[corner]);
  }
  return places;
}

Eigen::VectorXd
FlatAngleDefects(const FaceMatrix & F, const SurfaceConnectivity & connectivity, const CornerPlaces & places)
{
  Eigen::VectorXd defects = Eigen::VectorXd::Constant(connectivity.NumberOfVertices(), 2.0 * Pi);
  for (Eigen::Index face = 0; face < F.rows(); ++face)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::RowVector2d a = places.row(3 * face + (k + 1) % 3) - places.row(3 * face + k);
      const Eigen::RowVector2d b = places.row(3 * face + (k + 2) % 3) - places.row(3 * face + k);
      defects[F(face, k)] -= std::abs(std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b)));
    }
  }
  for (const std::vector<int> & loop : connectivity.BoundaryLoops())
  {
    for (const int vertex : loop)
    {
      defects[vertex] = 0.0;
    }
  }
  return defects;
}

DistortionQuantiles
QuantilesOfDilatation(const FlatDistortion & distortion, const std::vector<char> & leftOut)
{
  std::vector<double> values;
  for (std::size_t face = 0; face < distortion.isFlipped.size(); ++face)
  {
    if (!distortion.isFlipped[face] && (leftOut.empty() || !leftOut[face]))
    {
      values.push_back(distortion.dilatation[static_cast<Eigen::Index>(face)]);
    }
  }
  std::sort(values.begin(), values.end());
  constexpr double high = 0.95, highest = 0.99;
  return { SortedQuantile(values, 0.5),
           SortedQuantile(values, high),
           SortedQuantile(values, highest),
           static_cast<int>(values.size()) };
}

Eigen::VectorXd
TriangleQualities(const SideLengths & sides)
{
  Eigen::VectorXd qualities(sides.rows());
  for (Eigen::Index face = 0; face < sides.rows(); ++face)
  {
    const double a = sides(face, 0);
    const double b = sides(face, 1);
    const double c = sides(face, 2);
    // r = A / s and R = abc / 4A with s half the perimeter, so 2r/R = 8 A^2 / (s abc).
    const double product = (a + b + c) * a * b * c;
    qualities[face] = product > 0.0 ? std::min(1.0, HeronProduct(a, b, c) / product) : 0.0;
  }
  return qualities;
}

TriangleQuality
MeasureTriangleQuality(const SideLengths & sides, int bins)
{
  if (bins < 1)
  {
    throw InputError("a histogram requires at least one bin");
  }
  const Eigen::VectorXd qualities = TriangleQualities(sides);
  TriangleQuality       result;
  result.histogram.assign(bins, 0);
  for (const double quality : qualities)
  {
    ++result.histogram[std::min(bins - 1, static_cast<int>(quality * bins))];
  }
  if (qualities.size() > 0)
  {
    result.mean = qualities.mean();
    result.shareBelowThreshold = static_cast<double>((qualities.array() < qualityThreshold).count()) / qualities.size();
  }
  return result;
}
} // namespace shapeton
