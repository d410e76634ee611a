#include "shapetonColonCurve.h"

#include "shapetonColonDistance.h"
#include "shapetonCubicBSpline.h"
#include "shapetonForEachCell.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shapeton
{
using Eigen::Vector3d;

namespace
{
constexpr double c_CellSize = 8.0; // mm, of the search grid; chosen for speed
constexpr double c_Apart = 40.0;   // mm along the curve between two stretches
constexpr double c_NoTurn = 1e-24; // squared difference of unit tangents that is a rounding error

// A point of the smooth curve whose control points are the nodes of the path.
Vector3d
PathPoint(const ColonPath & path, double material)
{
  const auto above = std::upper_bound(path.material.begin(), path.material.end(), material);
  const int  last = static_cast<int>(path.nodes.size()) - 1;
  const int  i = std::clamp(static_cast<int>(above - path.material.begin()) - 1, 0, last - 1);
  const auto at = [&](int k) {
    return k < 0 ? Vector3d(2 * path.nodes[0] - path.nodes[1])
                 : (k > last ? Vector3d(2 * path.nodes[last] - path.nodes[last - 1]) : path.nodes[k]);
  };
  const CubicWeights w(std::clamp((material - path.material[i]) / (path.material[i + 1] - path.material[i]), 0.0, 1.0));
  return w.value[0] * at(i - 1) + w.value[1] * at(i) + w.value[2] * at(i + 1) + w.value[3] * at(i + 2);
}

void
PadEnds(std::vector<Vector3d> & control)
{
  const std::size_t n = control.size();
  const Vector3d    before = 2 * control[0] - control[1];
  const Vector3d    after = 2 * control[n - 1] - control[n - 2];
  control.insert(control.begin(), before);
  control.push_back(after);
}
} // namespace

int
ColonCurve::NumberOfSteps(double length)
{
  return static_cast<int>(std::lround(length / 2.0));
}

ColonCurve::ColonCurve(const ColonPath & path, const std::vector<double> & twist)
  : m_Steps(NumberOfSteps(path.Length())), m_Step(path.Length() / m_Steps)
{
  for (int k = 0; k <= m_Steps; ++k)
  {
    m_Control.push_back(PathPoint(path, k * m_Step));
  }
  PadEnds(m_Control);
  m_ArcLength.push_back(0.0);
  for (int k = 0; k <= m_Steps; ++k)
  {
    m_Samples.push_back(this->At(k).position);
  }
  for (int k = 0; k < m_Steps; ++k)
  {
    // Simpson's rule.
    const double a = this->At(k).first.norm(), b = this->At(k + 0.5).first.norm(), c = this->At(k + 1).first.norm();
    m_ArcLength.push_back(m_ArcLength.back() + (a + 4 * b + c) / 6.0);
  }
  this->FillFrames(twist);
}

// Rotation-minimizing frames by double reflection (Wang et al. 2008), then rotated by the twist.
void
ColonCurve::FillFrames(const std::vector<double> & twist)
{
  Vector3d tangent = this->At(0).first.normalized();
  Vector3d normal = Vector3d(0, -1, 0);
  normal = (normal - normal.dot(tangent) * tangent).normalized();
  for (int k = 0; k <= m_Steps; ++k)
  {
    if (k > 0)
    {
      const Vector3d step = m_Samples[k] - m_Samples[k - 1];
      const Vector3d reflected = normal - (2 * step.dot(normal) / step.squaredNorm()) * step;
      const Vector3d middle = tangent - (2 * step.dot(tangent) / step.squaredNorm()) * step;
      tangent = this->At(k).first.normalized();
      const Vector3d turn = tangent - middle;
      const double   size = turn.squaredNorm();
      normal = size > c_NoTurn ? Vector3d(reflected - (2 * turn.dot(reflected) / size) * turn) : reflected;
      normal = (normal - normal.dot(tangent) * tangent).normalized();
    }
    m_Normal.push_back(std::cos(twist[k]) * normal + std::sin(twist[k]) * tangent.cross(normal));
  }
  PadEnds(m_Normal);
}

ColonCurve::Frame
ColonCurve::At(double t) const
{
  const int          i = std::clamp(static_cast<int>(t), 0, m_Steps - 1);
  const CubicWeights w(t - i);
  const Vector3d *   p = &m_Control[i];
  Frame              frame;
  frame.position = w.value[0] * p[0] + w.value[1] * p[1] + w.value[2] * p[2] + w.value[3] * p[3];
  frame.first = w.first[0] * p[0] + w.first[1] * p[1] + w.first[2] * p[2] + w.first[3] * p[3];
  frame.second = w.second[0] * p[0] + w.second[1] * p[1] + w.second[2] * p[2] + w.second[3] * p[3];
  return frame;
}

Vector3d
ColonCurve::NormalAt(double t, const Vector3d & tangent) const
{
  const int          i = std::clamp(static_cast<int>(t), 0, m_Steps - 1);
  const CubicWeights w(t - i);
  const Vector3d *   p = &m_Normal[i];
  const Vector3d     n = w.value[0] * p[0] + w.value[1] * p[1] + w.value[2] * p[2] + w.value[3] * p[3];
  return (n - n.dot(tangent) * tangent).normalized();
}

Vector3d
ColonCurve::Direction(double t, double angle) const
{
  const Vector3d tangent = this->At(t).first.normalized();
  const Vector3d normal = this->NormalAt(t, tangent);
  return std::cos(angle) * normal + std::sin(angle) * tangent.cross(normal);
}

double
ColonCurve::ArcLengthAt(double t) const
{
  const int i = std::clamp(static_cast<int>(t), 0, m_Steps - 1);
  return m_ArcLength[i] + (t - i) * (m_ArcLength[i + 1] - m_ArcLength[i]);
}

double
ColonCurve::ParameterAt(double arcLength) const
{
  const auto above = std::upper_bound(m_ArcLength.begin(), m_ArcLength.end(), arcLength);
  const int  i = std::clamp(static_cast<int>(above - m_ArcLength.begin()) - 1, 0, m_Steps - 1);
  return std::clamp(i + (arcLength - m_ArcLength[i]) / (m_ArcLength[i + 1] - m_ArcLength[i]), 0.0, m_Steps * 1.0);
}

void
ColonCurve::BuildGrid(const std::vector<double> & reach)
{
  m_Reach = reach;
  Vector3d low = Vector3d::Constant(beyondAll);
  Vector3d high = -low;
  for (int k = 0; k <= m_Steps; ++k)
  {
    low = low.cwiseMin(m_Samples[k] - Vector3d::Constant(reach[k]));
    high = high.cwiseMax(m_Samples[k] + Vector3d::Constant(reach[k]));
  }
  m_GridLow = low;
  for (int axis = 0; axis < 3; ++axis)
  {
    m_GridSize[axis] = static_cast<int>((high[axis] - low[axis]) / c_CellSize) + 1;
  }
  std::vector<std::vector<Range>> cells(std::size_t(m_GridSize[0]) * m_GridSize[1] * m_GridSize[2]);
  for (int k = 0; k <= m_Steps; ++k)
  {
    this->AddSampleToCells(k, reach[k], cells);
  }
  m_CellBegin.assign(1, 0);
  m_Ranges.clear();
  for (const auto & cell : cells)
  {
    m_Ranges.insert(m_Ranges.end(), cell.begin(), cell.end());
    m_CellBegin.push_back(static_cast<std::uint32_t>(m_Ranges.size()));
  }
}

void
ColonCurve::AddSampleToCells(int sample, double reach, std::vector<std::vector<Range>> & cells) const
{
  // Half the cell diagonal plus a step of the curve.
  const double       radius = reach + 0.8661 * c_CellSize + m_Step;
  const Vector3d     at = (m_Samples[sample] - m_GridLow) / c_CellSize;
  std::array<int, 3> low, high;
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = std::max(0, static_cast<int>(at[axis] - radius / c_CellSize - 0.5));
    high[axis] = std::min(m_GridSize[axis], static_cast<int>(at[axis] + radius / c_CellSize) + 1);
  }
  ForEachCell(low, high, 1, [&](const std::array<int, 3> & cell) {
    if ((Vector3d(cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5) - at).norm() * c_CellSize > radius)
    {
      return;
    }
    auto & ranges = cells[(std::size_t(cell[2]) * m_GridSize[1] + cell[1]) * m_GridSize[0] + cell[0]];
    if (!ranges.empty() && ranges.back().last >= sample - 2)
    {
      ranges.back().last = sample;
    }
    else
    {
      ranges.push_back({ sample, sample });
    }
  });
}

void
ColonCurve::FindNear(const Vector3d & point, Near & near) const
{
  near.count = 0;
  const Vector3d at = (point - m_GridLow) / c_CellSize;
  if (!(at.minCoeff() >= 0 && at[0] < m_GridSize[0] && at[1] < m_GridSize[1] && at[2] < m_GridSize[2]))
  {
    return;
  }
  const std::size_t cell =
    (std::size_t(at[2]) * m_GridSize[1] + static_cast<int>(at[1])) * m_GridSize[0] + static_cast<int>(at[0]);
  std::array<int, MostNear>    samples{};
  std::array<double, MostNear> squares{};
  const double                 apart = c_Apart / m_Step;
  for (std::uint32_t r = m_CellBegin[cell]; r < m_CellBegin[cell + 1]; ++r)
  {
    const Range range = m_Ranges[r];
    double      before = 1e300;
    double      here = (m_Samples[range.first] - point).squaredNorm();
    for (int k = range.first; k <= range.last; ++k)
    {
      const double after = k < range.last ? (m_Samples[k + 1] - point).squaredNorm() : 1e300;
      if (before > here && here <= after && here < m_Reach[k] * m_Reach[k])
      {
        int slot = near.count;
        for (int i = 0; i < near.count; ++i)
        {
          slot = k - samples[i] < apart ? i : slot;
        }
        if (slot == near.count && near.count < MostNear)
        {
          squares[near.count++] = 1e300;
        }
        if (slot < MostNear && here < squares[slot])
        {
          samples[slot] = k;
          squares[slot] = here;
        }
      }
      before = here;
      here = after;
    }
  }
  for (int i = 0; i < near.count; ++i)
  {
    near.t[i] = this->Refine(point, samples[i]);
  }
}

double
ColonCurve::Refine(const Vector3d & point, int sample) const
{
  double t = sample;
  for (int round = 0; round < 3; ++round)
  {
    const Frame    frame = this->At(t);
    const Vector3d off = frame.position - point;
    const double   slope = off.dot(frame.first);
    const double   bend = std::max(off.dot(frame.second) + frame.first.squaredNorm(), 0.2 * frame.first.squaredNorm());
    t = std::clamp(
      t - std::clamp(slope / bend, -1.0, 1.0), std::max(0.0, sample - 1.0), std::min(1.0 * m_Steps, sample + 1.0));
  }
  return t;
}
} // namespace shapeton
