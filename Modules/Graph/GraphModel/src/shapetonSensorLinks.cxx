#include "shapetonSensorNetwork.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using Point = std::array<double, 2>;

double
SquaredDistance(const Point & a, const Point & b)
{
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

/** Points sorted into square cells. */
class PointCells
{
public:
  PointCells(const std::vector<Point> & points, double cell) : m_Points(points)
  {
    Point high = points[0];
    m_Low = points[0];
    for (const Point & p : points)
    {
      m_Low = { std::min(m_Low[0], p[0]), std::min(m_Low[1], p[1]) };
      high = { std::max(high[0], p[0]), std::max(high[1], p[1]) };
    }
    // At most as many cells as points: finer cells do not help for a small range.
    const double extent = std::max(high[0] - m_Low[0], high[1] - m_Low[1]);
    m_Cell = std::max({ cell, extent / std::ceil(std::sqrt(static_cast<double>(points.size()))), 1e-300 });
    m_Columns = static_cast<int>((high[0] - m_Low[0]) / m_Cell) + 1;
    m_Rows = static_cast<int>((high[1] - m_Low[1]) / m_Cell) + 1;
    m_PointsOfCell.resize(static_cast<std::size_t>(m_Columns) * m_Rows);
    for (int i = 0; i < static_cast<int>(points.size()); ++i)
    {
      m_PointsOfCell[Row(points[i][1]) * m_Columns + Column(points[i][0])].push_back(i);
    }
  }

  /** Whether `test` holds for any point in the cells that a disk intersects. */
  template <typename TTest>
  bool
  Any(const Point & center, double radius, const TTest & test) const
  {
    for (int row = Row(center[1] - radius); row <= Row(center[1] + radius); ++row)
    {
      for (int column = Column(center[0] - radius); column <= Column(center[0] + radius); ++column)
      {
        const auto & points = m_PointsOfCell[static_cast<std::size_t>(row) * m_Columns + column];
        if (std::any_of(points.begin(), points.end(), test))
        {
          return true;
        }
      }
    }
    return false;
  }

private:
  int
  Column(double x) const
  {
    return std::max(0, std::min(m_Columns - 1, static_cast<int>(std::floor((x - m_Low[0]) / m_Cell))));
  }
  int
  Row(double y) const
  {
    return std::max(0, std::min(m_Rows - 1, static_cast<int>(std::floor((y - m_Low[1]) / m_Cell))));
  }

  const std::vector<Point> &    m_Points;
  Point                         m_Low;
  double                        m_Cell;
  int                           m_Columns;
  int                           m_Rows;
  std::vector<std::vector<int>> m_PointsOfCell;
};

/** Whether another point is in the diametral disk of the link, including its boundary. */
bool
IsBlocked(const std::vector<Point> & points, const PointCells & cells, int a, int b)
{
  const Point  center{ 0.5 * (points[a][0] + points[b][0]), 0.5 * (points[a][1] + points[b][1]) };
  const double radius = 0.5 * std::sqrt(SquaredDistance(points[a], points[b]));
  return cells.Any(center, radius, [&](int c) {
    return c != a && c != b &&
           (points[a][0] - points[c][0]) * (points[b][0] - points[c][0]) +
               (points[a][1] - points[c][1]) * (points[b][1] - points[c][1]) <=
             0.0;
  });
}
} // namespace

std::vector<std::array<int, 2>>
LinksBetween(const std::vector<Point> & points, const std::vector<double> & reach, bool gabriel)
{
  std::vector<std::array<int, 2>> links;
  if (points.empty())
  {
    return links;
  }
  const PointCells cells(points, *std::max_element(reach.begin(), reach.end()));
  for (int a = 0; a < static_cast<int>(points.size()); ++a)
  {
    std::vector<int> partners;
    cells.Any(points[a], reach[a], [&](int b) {
      const double both = std::min(reach[a], reach[b]);
      if (b > a && SquaredDistance(points[a], points[b]) <= both * both && !(gabriel && IsBlocked(points, cells, a, b)))
      {
        partners.push_back(b);
      }
      return false;
    });
    std::sort(partners.begin(), partners.end());
    for (const int b : partners)
    {
      links.push_back({ a, b });
    }
  }
  return links;
}
} // namespace shapeton
