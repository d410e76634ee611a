#ifndef shapetonSpaceCells_h
#define shapetonSpaceCells_h

#include "shapetonSurfaceMesh.h"

#include <array>
#include <numeric>

namespace shapeton
{
/** The cells of the nodes, which are the first points, and of the edges, whose points are appended. */
template <typename TPoint>
std::vector<std::vector<int>>
CurvesInSpace(const std::vector<std::vector<TPoint>> & edges, std::vector<TPoint> & points)
{
  std::vector<std::vector<int>> curves(points.size(), std::vector<int>(1));
  for (std::size_t node = 0; node < points.size(); ++node)
  {
    curves[node][0] = static_cast<int>(node);
  }
  for (const std::vector<TPoint> & edge : edges)
  {
    std::vector<int> & curve = curves.emplace_back(edge.size());
    std::iota(curve.begin(), curve.end(), static_cast<int>(points.size()));
    points.insert(points.end(), edge.begin(), edge.end());
  }
  return curves;
}

/** The cell arrays kind (0 node, 1 edge, 2 triangle) and id, counted from 0 for each kind.
 * \param numbers of cells of each kind. */
inline std::vector<SurfaceArray>
CellArraysInSpace(const std::array<std::size_t, 3> & numbers)
{
  SurfaceArray kind{ "kind", {}, true }, id{ "id", {}, true };
  kind.values.resize(static_cast<Eigen::Index>(numbers[0] + numbers[1] + numbers[2]), 1);
  id.values.resize(kind.values.rows(), 1);
  Eigen::Index row = 0;
  for (std::size_t k = 0; k < numbers.size(); ++k)
  {
    for (std::size_t i = 0; i < numbers[k]; ++i, ++row)
    {
      kind.values(row, 0) = static_cast<double>(k);
      id.values(row, 0) = static_cast<double>(i);
    }
  }
  return { kind, id };
}
} // namespace shapeton

#endif
