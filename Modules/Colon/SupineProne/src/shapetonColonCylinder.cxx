#include "shapetonColonCylinder.h"

#include "shapetonFlatColonAxis.h"
#include "shapetonExceptions.h"
#include "shapetonPi.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{

/** Smooths the distances, since steps are artifacts of the assignment, and enforces a minimum slope to make them
 * distinct. */
std::vector<double>
StrictlyAscending(const std::vector<double> & values, int reach, double leastStep)
{
  const int           last = static_cast<int>(values.size()) - 1;
  std::vector<double> ascending(values.size());
  for (int i = 0; i <= last; ++i)
  {
    const int near = std::min({ reach, i, last - i }); // symmetric, so that the ends remain fixed
    double    sum = 0.0;
    for (int j = i - near; j <= i + near; ++j)
    {
      sum += values[j];
    }
    ascending[i] = sum / (2 * near + 1);
    ascending[i] = i > 0 ? std::max(ascending[i], ascending[i - 1] + leastStep) : ascending[i];
  }
  return ascending;
}
} // namespace

double
TurnDifference(double turn, double from)
{
  const double difference = turn - from + 0.5;
  return difference - std::floor(difference) - 0.5;
}

ColonCylinder::ColonCylinder(const FlatColon & flat, const CurveSet & centerline) : m_Grid(&flat.Grid())
{
  const FlatColonGrid & grid = *m_Grid;
  const FlatColonAxis & axis = flat.Axis();
  std::vector<double>   distance = grid.HasArcLength() ? DistanceOfColumns(grid) : DistanceOfColumns(axis, centerline);
  if (distance.size() < 2 || !(distance.back() > distance.front()))
  {
    throw InputError("the array arcLength is missing from the flat surface and its centerline; create them with "
                     "ColonSegmentation and ColonFlattening (the parameter \"centerline\")");
  }
  constexpr double smoothing = 5.0;  // mm; chosen: steps of the assignment are shorter
  constexpr double leastStep = 0.01; // pixels; chosen: only makes distances distinct
  m_Arc = StrictlyAscending(
    distance, static_cast<int>(std::ceil(smoothing / grid.PixelSize())), leastStep * grid.PixelSize());
  m_Radii = axis.radii;
  m_Around = 2.0 * Pi * m_Radii.mean();
}

double
ColonCylinder::ArcOfColumn(double column) const
{
  const double place = column - 0.5;
  const int    last = static_cast<int>(m_Arc.size()) - 1;
  const int    i = std::clamp(static_cast<int>(std::floor(place)), 0, last - 1);
  return m_Arc[i] + (place - i) * (m_Arc[i + 1] - m_Arc[i]);
}

double
ColonCylinder::ColumnOfArc(double s) const
{
  const int after = static_cast<int>(std::upper_bound(m_Arc.begin(), m_Arc.end(), s) - m_Arc.begin());
  const int i = std::clamp(after - 1, 0, static_cast<int>(m_Arc.size()) - 2);
  return i + (s - m_Arc[i]) / (m_Arc[i + 1] - m_Arc[i]) + 0.5;
}

CylinderPlace
ColonCylinder::PlaceOfUv(const Eigen::Vector2d & uv) const
{
  const double turn = uv.y() / m_Grid->Circumference();
  return { this->ArcOfColumn(uv.x() / m_Grid->PixelSize()), m_Grid->IsMirrored() ? -turn : turn };
}

Eigen::Vector2d
ColonCylinder::UvOfPlace(const CylinderPlace & place) const
{
  const double turn = m_Grid->IsMirrored() ? -place.turn : place.turn;
  return { this->ColumnOfArc(place.s) * m_Grid->PixelSize(), (turn - std::floor(turn)) * m_Grid->Circumference() };
}

Eigen::Vector3d
ColonCylinder::PointOfPlace(const CylinderPlace & place) const
{
  const int             lastColumn = m_Grid->Columns() - 1;
  const double          column = std::clamp(this->ColumnOfArc(place.s) - 0.5, 0.0, static_cast<double>(lastColumn));
  const Eigen::Vector2d uvOfFirst = m_Grid->UvOfPixel(0, 0);
  const double          turnOfFirst = (m_Grid->IsMirrored() ? -1.0 : 1.0) * uvOfFirst.y() / m_Grid->Circumference();
  const double          row = (place.turn - turnOfFirst - std::floor(place.turn - turnOfFirst)) * m_Grid->Rows();
  const int             i = std::min(static_cast<int>(column), std::max(0, lastColumn - 1));
  const int             j = static_cast<int>(row);
  const double          x = column - i;
  const double          y = row - j;
  Eigen::Vector3d       sum = Eigen::Vector3d::Zero();
  double                weight = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const int             dx = corner % 2;
    const int             dy = corner / 2;
    const Eigen::Vector3d point = m_Grid->PointOfPixel(std::min(i + dx, lastColumn), j + dy);
    const double          share = (dx ? x : 1.0 - x) * (dy ? y : 1.0 - y);
    if (point.allFinite())
    {
      sum += share * point;
      weight += share;
    }
  }
  return sum / weight;
}
} // namespace shapeton
