#include "shapetonCurveShape.h"

#include "shapetonInterruption.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
DistanceField::DistanceField(const LumenDistanceImage * image) : m_Values(image->GetBufferPointer())
{
  for (int a = 0; a < 3; ++a)
  {
    m_Size[a] = static_cast<int>(image->GetBufferedRegion().GetSize(a));
    m_Spacing[a] = image->GetSpacing()[a];
  }
}

template <typename TAdd>
void
DistanceField::Interpolate(const Eigen::Vector3d & position, const TAdd & add) const
{
  Eigen::Array3i  lower;
  Eigen::Array3i  upper;
  Eigen::Vector3d share;
  for (int a = 0; a < 3; ++a)
  {
    const double voxel = std::clamp(position[a] / m_Spacing[a], 0.0, m_Size[a] - 1.0);
    lower[a] = static_cast<int>(voxel);
    upper[a] = std::min(lower[a] + 1, m_Size[a] - 1);
    share[a] = voxel - lower[a];
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    double      weight = 1.0;
    std::size_t index = 0;
    for (int a = 2; a >= 0; --a)
    {
      const bool isUpper = (corner >> a & 1) != 0;
      weight *= isUpper ? share[a] : 1.0 - share[a];
      index = index * m_Size[a] + (isUpper ? upper[a] : lower[a]);
    }
    add(weight, m_Values[index]);
  }
}

double
DistanceField::At(const Eigen::Vector3d & position) const
{
  double sum = 0.0;
  this->Interpolate(position, [&sum](double weight, float value) { sum += weight * value; });
  return sum;
}

double
DistanceField::Occupancy(const Eigen::Vector3d & position) const
{
  double sum = 0.0;
  this->Interpolate(position, [&sum](double weight, float value) { sum += value > 0.0F ? weight : 0.0; });
  return sum;
}

double
CurveLength(const CurvePoints & points)
{
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += (points[i] - points[i - 1]).norm();
  }
  return length;
}

CurvePoints
ResampleCurve(const CurvePoints & points, double step)
{
  const double length = CurveLength(points);
  if (points.size() < 2 || length == 0.0)
  {
    return { points.begin(), points.begin() + std::min<std::size_t>(points.size(), 1) };
  }
  const int   number = std::max(1, static_cast<int>(std::lround(length / step)));
  CurvePoints result{ points.front() };
  double      passed = 0.0;
  std::size_t at = 1;
  for (int i = 1; i < number; ++i)
  {
    const double wanted = length * i / number;
    double       part = (points[at] - points[at - 1]).norm();
    while (at + 1 < points.size() && passed + part < wanted)
    {
      passed += part;
      ++at;
      part = (points[at] - points[at - 1]).norm();
    }
    const double share = part > 0.0 ? std::min(1.0, (wanted - passed) / part) : 0.0;
    result.push_back(points[at - 1] + share * (points[at] - points[at - 1]));
  }
  result.push_back(points.back());
  return result;
}

CurvePoints
SmoothCurve(const CurvePoints & points, double step, double sigma, const DistanceField * field)
{
  // Each pass with weights 1/4, 1/2, 1/4 increases the variance by step^2 / 2.
  const int   passes = static_cast<int>(std::lround(2.0 * sigma * sigma / (step * step)));
  CurvePoints result = points;
  CurvePoints next = points;
  for (int pass = 0; pass < passes; ++pass)
  {
    Interruption::Check();
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
    {
      next[i] = 0.25 * result[i - 1] + 0.5 * result[i] + 0.25 * result[i + 1];
      if (field && field->At(next[i]) < std::min(1.0, 0.5 * field->At(result[i])))
      {
        next[i] = result[i];
      }
    }
    result.swap(next);
  }
  return result;
}

CurvePoints
BridgeGap(const Eigen::Vector3d & a,
          const Eigen::Vector3d & out,
          const Eigen::Vector3d & b,
          const Eigen::Vector3d & in,
          double                  step)
{
  const double          distance = (b - a).norm();
  const Eigen::Vector3d straight = distance > 0.0 ? Eigen::Vector3d((b - a) / distance) : out;
  // Prevents a badly oriented end from deflecting the bridge far to the side.
  const auto tangent = [&](const Eigen::Vector3d & direction) {
    const double     forward = std::max(0.0, direction.dot(straight));
    constexpr double least = 0.25; // of the distance
    return Eigen::Vector3d(distance * (least + (1.0 - least) * forward) * direction);
  };
  const Eigen::Vector3d ta = tangent(out);
  const Eigen::Vector3d tb = tangent(in);
  // Number of intervals of the Hermite curve; chosen finer than the step to which it is resampled.
  constexpr int fine = 200;
  CurvePoints   points;
  for (int i = 0; i <= fine; ++i)
  {
    const double t = static_cast<double>(i) / fine;
    const double s = 1.0 - t;
    points.push_back((1.0 + 2.0 * t) * s * s * a + t * s * s * ta + (3.0 - 2.0 * t) * t * t * b - s * t * t * tb);
  }
  points = ResampleCurve(points, step);
  return { points.begin() + 1, points.end() - (points.size() > 1 ? 1 : 0) };
}
} // namespace shapeton
