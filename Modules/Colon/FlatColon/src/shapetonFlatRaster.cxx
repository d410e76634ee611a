#include "shapetonFlatRaster.h"

#include "shapetonParallelFor.h"

#include <array>
#include <cmath>

namespace shapeton
{
namespace
{
/** Columns (pixels) per task. Chosen: there are many more tasks than threads, but few faces are in two bands. */
constexpr int bandColumns = 128;

using Place = std::array<std::int64_t, 2>;

/** Twice the area of a triangle, positive if counterclockwise in (u, v). */
std::int64_t
Area(const Place & a, const Place & b, const Place & c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/** The first pixel whose center is at or after a coordinate. */
std::int64_t
FirstPixel(std::int64_t place)
{
  const std::int64_t shifted = place - SnappedMap::unit / 2 + SnappedMap::unit - 1;
  return shifted >> SnappedMap::bits; // floor, also for negative values
}

/** Top-left rule: points on an edge belong to the triangle for which it is a lower or left edge. */
bool
OwnsItsPoints(const Place & from, const Place & to)
{
  return to[1] == from[1] ? to[0] > from[0] : to[1] < from[1];
}

/** A triangle with positive area, to test whether pixel centers are in it. */
class Triangle
{
public:
  Triangle(const SnappedMap & map, const FaceMatrix & faces, int face)
  {
    for (int k = 0; k < 3; ++k)
    {
      m_Corners[k] = { map.u[faces(face, k)], map.v[faces(face, k)] };
    }
    const std::int64_t area = Area(m_Corners[0], m_Corners[1], m_Corners[2]);
    m_Sign = area > 0 ? 1 : area < 0 ? -1 : 0;
    if (m_Sign < 0)
    {
      std::swap(m_Corners[1], m_Corners[2]);
    }
  }

  int
  Sign() const
  {
    return m_Sign;
  }
  std::int64_t
  Least(int axis) const
  {
    return std::min({ m_Corners[0][axis], m_Corners[1][axis], m_Corners[2][axis] });
  }
  std::int64_t
  Greatest(int axis) const
  {
    return std::max({ m_Corners[0][axis], m_Corners[1][axis], m_Corners[2][axis] });
  }
  bool
  Holds(std::int64_t column, std::int64_t row) const
  {
    const Place middle{ column * SnappedMap::unit + SnappedMap::unit / 2,
                        row * SnappedMap::unit + SnappedMap::unit / 2 };
    for (int k = 0; k < 3; ++k)
    {
      const Place &      from = m_Corners[k];
      const Place &      to = m_Corners[(k + 1) % 3];
      const std::int64_t side = Area(from, to, middle);
      if (side < 0 || (side == 0 && !OwnsItsPoints(from, to)))
      {
        return false;
      }
    }
    return true;
  }

private:
  std::array<Place, 3> m_Corners;
  int                  m_Sign;
};

/** Ascending indices of the faces that overlap each band of columns. */
std::vector<std::vector<int>>
FacesOfBands(const SnappedMap & map, const FaceMatrix & faces, int columns)
{
  std::vector<std::vector<int>> bands((columns + bandColumns - 1) / bandColumns);
  for (int face = 0; face < faces.rows(); ++face)
  {
    const Triangle     triangle(map, faces, face);
    const std::int64_t first = std::max<std::int64_t>(0, FirstPixel(triangle.Least(0)));
    const std::int64_t last = std::min<std::int64_t>(columns, FirstPixel(triangle.Greatest(0) + 1)) - 1;
    for (std::int64_t band = first / bandColumns; first <= last && band <= last / bandColumns; ++band)
    {
      bands[band].push_back(face);
    }
  }
  return bands;
}

/** Rasterizes a band of columns. */
struct Band
{
  std::vector<int> & faceOfPixel;
  int                columns;
  int                rows;
  int                first;
  int                last;

  void
  Fill(const Triangle & triangle, int face) const
  {
    const std::int64_t left = std::max<std::int64_t>(first, FirstPixel(triangle.Least(0)));
    const std::int64_t right = std::min<std::int64_t>(last, FirstPixel(triangle.Greatest(0) + 1) - 1);
    const std::int64_t bottom = FirstPixel(triangle.Greatest(1) + 1);
    for (std::int64_t row = FirstPixel(triangle.Least(1)); row < bottom; ++row)
    {
      const std::int64_t wrapped = ((row % rows) + rows) % rows;
      for (std::int64_t column = left; column <= right; ++column)
      {
        int & pixel = faceOfPixel[wrapped * columns + column];
        if (pixel < 0 && triangle.Holds(column, row))
        {
          pixel = face;
        }
      }
    }
  }
};
} // namespace

SnappedMap
SnapMap(const Eigen::MatrixX2d & uv, const std::vector<int> & sourceOfVertex, double pixelSize, int rows)
{
  constexpr double wholeTurn = 1e-6; // relative to the circumference; allows for rounding
  const double     circumference = pixelSize * rows;
  const double     scale = SnappedMap::unit / pixelSize;
  std::vector<int> firstCopy(sourceOfVertex.size(), -1);
  SnappedMap       map;
  map.u.reserve(sourceOfVertex.size());
  map.v.reserve(sourceOfVertex.size());
  for (std::size_t vertex = 0; vertex < sourceOfVertex.size(); ++vertex)
  {
    int & first = firstCopy[sourceOfVertex[vertex]];
    first = first < 0 ? static_cast<int>(vertex) : first;
    const Eigen::Vector2d difference = uv.row(vertex) - uv.row(first);
    const double          turns = std::round(difference.y() / circumference);
    const bool            isCopy = std::abs(difference.x()) < wholeTurn * circumference &&
                        std::abs(difference.y() - turns * circumference) < wholeTurn * circumference;
    const Eigen::Vector2d place = isCopy ? uv.row(first) : uv.row(vertex);
    const double          turn = isCopy ? turns * rows * SnappedMap::unit : 0.0;
    map.u.push_back(std::llround(place.x() * scale));
    map.v.push_back(std::llround(place.y() * scale) + static_cast<std::int64_t>(turn));
  }
  return map;
}

std::vector<int>
RasterizeFaces(const SnappedMap & map, const FaceMatrix & faces, int columns, int rows, int sign)
{
  std::vector<int> faceOfPixel(static_cast<std::size_t>(columns) * rows, -1);
  const auto       bands = FacesOfBands(map, faces, columns);
  ParallelFor(bands.size(), [&](std::size_t number) {
    const int  first = static_cast<int>(number) * bandColumns;
    const Band band{ faceOfPixel, columns, rows, first, std::min(columns, first + bandColumns) - 1 };
    for (const int wanted : { sign, -sign })
    {
      for (const int face : bands[number])
      {
        const Triangle triangle(map, faces, face);
        if (triangle.Sign() == wanted)
        {
          band.Fill(triangle, face);
        }
      }
    }
  });
  return faceOfPixel;
}
} // namespace shapeton
