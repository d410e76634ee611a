#include "shapetonColonPointPairs.h"

#include "shapetonExceptions.h"

#include <map>

namespace shapeton
{
namespace
{
/** Vertex index by materialId. */
std::map<int, int>
VerticesOutsideCollapse(const CurveSet & points, const std::string & what)
{
  const Eigen::VectorXd material = PointValues(points, "materialId", what);
  const Eigen::VectorXd collapsed = PointValues(points, "collapsed", what);
  std::map<int, int>    vertices;
  for (Eigen::Index i = 0; i < material.size(); ++i)
  {
    if (collapsed[i] == 0.0)
    {
      vertices[static_cast<int>(material[i])] = static_cast<int>(i);
    }
  }
  return vertices;
}
} // namespace

CsvTable
TableOfPointPairs(const CurveSet & first, const CurveSet & second)
{
  const std::map<int, int> vertices = VerticesOutsideCollapse(first, "the first position");
  const std::map<int, int> others = VerticesOutsideCollapse(second, "the second position");
  CsvTable                 table({ "sx", "sy", "sz", "px", "py", "pz" });
  for (const auto & [material, vertex] : vertices)
  {
    const auto other = others.find(material);
    if (other == others.end())
    {
      continue;
    }
    std::vector<std::string> cells;
    for (int k = 0; k < 6; ++k)
    {
      cells.push_back(CsvTable::Rounded(k < 3 ? first.V(vertex, k) : second.V(other->second, k - 3), 6));
    }
    table.AddRow(cells);
  }
  if (table.GetRows().empty())
  {
    throw InputError("the positions have no materialId in common; use positions of the same seed");
  }
  return table;
}
} // namespace shapeton
