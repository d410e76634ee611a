#include "shapetonConformalTube.h"
#include "shapetonPi.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
constexpr int levelsOfTube = 500; // chosen; lengths are measured at each

struct ValuedCorner
{
  double          value;
  Eigen::Vector3d place;
};

/** Length of the line value = level in a triangle with corners sorted by value. A level at (or, by rounding, below) the
 * lowest corners has length 0 here; the triangle below counts it. */
double
LengthInTriangle(const std::array<ValuedCorner, 3> & corners, double level)
{
  const auto between = [level](const ValuedCorner & low, const ValuedCorner & high) -> Eigen::Vector3d {
    const double part = level > low.value ? (level - low.value) / (high.value - low.value) : 0.0;
    return low.place + part * (high.place - low.place);
  };
  const Eigen::Vector3d along = between(corners[0], corners[2]);
  const Eigen::Vector3d other =
    level < corners[1].value ? between(corners[0], corners[1]) : between(corners[1], corners[2]);
  return (other - along).norm();
}
} // namespace

double
MeanLevelLength(const SurfaceMesh & mesh, const Eigen::VectorXd & u)
{
  double sum = 0.0;
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const Eigen::Vector3d a = mesh.V.row(mesh.F(f, 0));
    const Eigen::Vector3d b = mesh.V.row(mesh.F(f, 1));
    const Eigen::Vector3d c = mesh.V.row(mesh.F(f, 2));
    // |grad u| A: the gradient is this vector, turned by 90 degrees in the face, over A.
    sum += 0.5 * (u[mesh.F(f, 0)] * (c - b) + u[mesh.F(f, 1)] * (a - c) + u[mesh.F(f, 2)] * (b - a)).norm();
  }
  return sum;
}

Eigen::VectorXd
LevelLengths(const SurfaceMesh & mesh, const Eigen::VectorXd & u, int number)
{
  Eigen::VectorXd lengths = Eigen::VectorXd::Zero(number);
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    std::array<ValuedCorner, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = { u[mesh.F(f, k)], mesh.V.row(mesh.F(f, k)) };
    }
    std::sort(corners.begin(), corners.end(), [](const auto & a, const auto & b) { return a.value < b.value; });
    const int first = std::max(0, static_cast<int>(std::ceil(corners[0].value * number - 0.5)));
    for (int i = first; i < number && (i + 0.5) / number < corners[2].value; ++i)
    {
      lengths[i] += LengthInTriangle(corners, (i + 0.5) / number);
    }
  }
  return lengths;
}

double
NarrowestLevelRadius(const SurfaceMesh & mesh, const Eigen::VectorXd & u)
{
  const Eigen::VectorXd      lengths = LevelLengths(mesh, u, levelsOfTube);
  const SurfaceArray * const bridged = FindSurfaceArray(mesh.cellArrays, "bridged");
  std::vector<char>          isBridged(levelsOfTube, 0);
  for (int f = 0; bridged && f < mesh.NumberOfFaces(); ++f)
  {
    const auto [low, high] = std::minmax({ u[mesh.F(f, 0)], u[mesh.F(f, 1)], u[mesh.F(f, 2)] });
    const int first = std::max(0, static_cast<int>(std::ceil(low * levelsOfTube - 0.5)));
    for (int i = first; bridged->values(f, 0) != 0.0 && i < levelsOfTube && (i + 0.5) / levelsOfTube < high; ++i)
    {
      isBridged[i] = 1;
    }
  }
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < levelsOfTube; ++i)
  {
    least = isBridged[i] ? least : std::min(least, lengths[i]);
  }
  return (std::isfinite(least) ? least : lengths.minCoeff()) / (2.0 * Pi);
}
} // namespace shapeton
