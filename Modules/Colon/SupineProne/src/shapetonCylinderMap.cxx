#include "shapetonCylinderMap.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double beyond = 1000.0; ///< mm, added at each end; chosen: beyond any colon
constexpr double binSize = 5.0;   ///< mm along the target; chosen
constexpr int    binAngles = 36;  // around, 10 degrees each; chosen: bins hold few triangles

/** Converts a distance (mm) to a position in rows of the extended nodes. */
double
RowPlace(const CylinderNodes & nodes, double s)
{
  const double row = (s - nodes.begin) / nodes.step;
  const double last = nodes.Rows() - 1.0;
  const double past = beyond / nodes.step;
  return row < 0.0 ? std::max(0.0, 1.0 + row / past) : row > last ? 1.0 + last + (row - last) / past : 1.0 + row;
}

double
SOfRow(const CylinderNodes & nodes, double row)
{
  const double last = nodes.Rows() - 1.0;
  const double inner = row - 1.0;
  const double past = inner < 0.0 ? inner : std::max(0.0, inner - last);
  return nodes.begin + std::clamp(inner, 0.0, last) * nodes.step + past * beyond;
}

CylinderNodes
Extended(const CylinderNodes & nodes)
{
  const int     rows = nodes.Rows();
  CylinderNodes extended = nodes;
  extended.s.resize(rows + 2, nodes.Angles());
  extended.s << nodes.s.row(0).array() - beyond, nodes.s, nodes.s.row(rows - 1).array() + beyond;
  extended.turn.resize(rows + 2, nodes.Angles());
  extended.turn << nodes.turn.row(0), nodes.turn, nodes.turn.row(rows - 1);
  return extended;
}

/** Corners of triangle 2 * (row * angles + angle) and of its successor: nodes (row, angle), (row + 1, angle), (row + 1,
 * angle + 1) and (row, angle), (row + 1, angle + 1), (row, angle + 1). */
struct TriangleCorners
{
  int           row;
  int           angle;
  bool          isSecond;
  CylinderPlace a, b, c;
};

TriangleCorners
CornersOf(const CylinderNodes & nodes, int triangle)
{
  const int  cell = triangle / 2;
  const int  row = cell / nodes.Angles();
  const int  angle = cell % nodes.Angles();
  const bool isSecond = triangle % 2 != 0;
  return { row,
           angle,
           isSecond,
           nodes.At(row, angle),
           isSecond ? nodes.At(row + 1, angle + 1) : nodes.At(row + 1, angle),
           isSecond ? nodes.At(row, angle + 1) : nodes.At(row + 1, angle + 1) };
}

/** Twice the signed area (mm * turns), negative for flipped triangles. */
double
AreaOf(const CylinderPlace & a, const CylinderPlace & b, const CylinderPlace & c)
{
  return (b.s - a.s) * (c.turn - a.turn) - (c.s - a.s) * (b.turn - a.turn);
}
} // namespace

CylinderMap::CylinderMap(CylinderNodes nodes) : m_Nodes(std::move(nodes)), m_Extended(Extended(m_Nodes))
{
  this->MakeBins();
}

void
CylinderMap::MakeBins()
{
  m_BinBegin = m_Nodes.s.minCoeff();
  m_BinRows = static_cast<int>((m_Nodes.s.maxCoeff() - m_BinBegin) / binSize) + 1;
  m_Bins.assign(static_cast<std::size_t>(m_BinRows) * binAngles, {});
  const int triangles = 2 * (m_Extended.Rows() - 1) * m_Extended.Angles();
  for (int triangle = 0; triangle < triangles; ++triangle)
  {
    const TriangleCorners t = CornersOf(m_Extended, triangle);
    const auto [low, high] = std::minmax({ t.a.s, t.b.s, t.c.s });
    const auto [left, right] = std::minmax({ t.a.turn, t.b.turn, t.c.turn });
    const int firstRow = std::clamp(static_cast<int>((low - m_BinBegin) / binSize), 0, m_BinRows - 1);
    const int lastRow = std::clamp(static_cast<int>((high - m_BinBegin) / binSize), 0, m_BinRows - 1);
    const int firstAngle = static_cast<int>(std::floor(left * binAngles));
    const int lastAngle = std::min(static_cast<int>(std::floor(right * binAngles)), firstAngle + binAngles - 1);
    for (int row = firstRow; row <= lastRow; ++row)
    {
      for (int angle = firstAngle; angle <= lastAngle; ++angle)
      {
        m_Bins[static_cast<std::size_t>(row) * binAngles + ((angle % binAngles) + binAngles) % binAngles].push_back(
          triangle);
      }
    }
  }
}

CylinderPlace
CylinderMap::Forward(const CylinderPlace & place) const
{
  const double        row = RowPlace(m_Nodes, place.s);
  const double        around = std::floor(place.turn);
  const double        column = (place.turn - around) * m_Nodes.Angles();
  const int           i = std::clamp(static_cast<int>(row), 0, m_Extended.Rows() - 2);
  const int           j = std::clamp(static_cast<int>(column), 0, m_Nodes.Angles() - 1);
  const double        p = row - i;
  const double        q = column - j;
  const CylinderPlace a = m_Extended.At(i, j);
  const CylinderPlace c = m_Extended.At(i + 1, j + 1);
  const CylinderPlace b = p >= q ? m_Extended.At(i + 1, j) : m_Extended.At(i, j + 1);
  const double        first = p >= q ? p - q : q - p; // weight of corner b
  const double        both = std::min(p, q);          // weight of corner c
  const double        rest = 1.0 - first - both;
  return { rest * a.s + first * b.s + both * c.s, rest * a.turn + first * b.turn + both * c.turn + around };
}

std::optional<CylinderPlace>
CylinderMap::InverseOnTriangle(int triangle, const CylinderPlace & place) const
{
  const TriangleCorners t = CornersOf(m_Extended, triangle);
  const double          area = AreaOf(t.a, t.b, t.c);
  if (!(area > 0.0))
  {
    return std::nullopt;
  }
  const double  middle = (t.a.turn + t.b.turn + t.c.turn) / 3.0;
  CylinderPlace at = place;
  at.turn = middle + TurnDifference(place.turn, middle);
  const double     ofB = AreaOf(t.a, at, t.c) / area;
  const double     ofC = AreaOf(t.a, t.b, at) / area;
  constexpr double tolerance = 1e-9; // of barycentric coordinates, for rounding
  if (ofB < -tolerance || ofC < -tolerance || ofB + ofC > 1.0 + tolerance)
  {
    return std::nullopt;
  }
  const double p = t.isSecond ? ofB : ofB + ofC;
  const double q = t.isSecond ? ofB + ofC : ofC;
  const double turn = (t.angle + q) / m_Nodes.Angles();
  return CylinderPlace{ SOfRow(m_Nodes, t.row + p), turn - std::floor(turn) };
}

std::optional<CylinderPlace>
CylinderMap::Inverse(const CylinderPlace & place) const
{
  const int row = std::clamp(static_cast<int>((place.s - m_BinBegin) / binSize), 0, m_BinRows - 1);
  const int angle = static_cast<int>((place.turn - std::floor(place.turn)) * binAngles) % binAngles;
  for (const int triangle : m_Bins[static_cast<std::size_t>(row) * binAngles + angle])
  {
    if (const std::optional<CylinderPlace> found = this->InverseOnTriangle(triangle, place))
    {
      return found;
    }
  }
  return std::nullopt;
}

int
CylinderMap::Flips() const
{
  int       flips = 0;
  const int triangles = 2 * (m_Nodes.Rows() - 1) * m_Nodes.Angles();
  for (int triangle = 0; triangle < triangles; ++triangle)
  {
    const TriangleCorners t = CornersOf(m_Nodes, triangle);
    flips += !(AreaOf(t.a, t.b, t.c) > 0.0);
  }
  return flips;
}
} // namespace shapeton
