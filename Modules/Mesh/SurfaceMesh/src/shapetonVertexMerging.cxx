#include "shapetonVertexMerging.h"

#include "shapetonDisjointSets.h"
#include "shapetonSurfaceFormats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace shapeton
{
namespace
{
using Cell = std::array<std::int64_t, 3>;

struct HashOfCell
{
  std::size_t
  operator()(const Cell & cell) const
  {
    std::uint64_t hash = 0;
    for (const std::int64_t c : cell)
    {
      hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }
};

/** Vertices in cubic cells. */
class VertexCells
{
public:
  VertexCells(const SurfaceMesh & mesh, double side)
    : m_V(mesh.V), m_Corner(CornersOfFaces(mesh)[0]), m_Side(side), m_Next(mesh.V.rows(), -1)
  {
    m_First.reserve(mesh.V.rows());
  }

  void
  Add(int v)
  {
    const auto [place, isNew] = m_First.emplace(this->CellOf(v), v);
    if (!isNew)
    {
      m_Next[v] = place->second;
      place->second = v;
    }
  }

  /** Calls visit(w) for the added vertices in the cells up to `distance` around v, which is at most the side. */
  template <typename TVisit>
  void
  VisitNear(int v, double distance, const TVisit & visit) const
  {
    const Cell own = this->CellOf(v);
    int        low[3], high[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double place = m_V(v, axis) - m_Corner[axis] - static_cast<double>(own[axis]) * m_Side;
      low[axis] = place > distance ? 0 : -1;
      high[axis] = m_Side - place > distance ? 0 : 1;
    }
    for (int i = low[0]; i <= high[0]; ++i)
    {
      for (int j = low[1]; j <= high[1]; ++j)
      {
        for (int k = low[2]; k <= high[2]; ++k)
        {
          const auto near = m_First.find({ own[0] + i, own[1] + j, own[2] + k });
          for (int w = near == m_First.end() ? -1 : near->second; w >= 0; w = m_Next[w])
          {
            visit(w);
          }
        }
      }
    }
  }

private:
  Cell
  CellOf(int v) const
  {
    constexpr double farthest = 1e15; // farther cells are one cell, whose vertices are all compared
    Cell             cell;
    for (int axis = 0; axis < 3; ++axis)
    {
      cell[axis] = static_cast<std::int64_t>(
        std::floor(std::clamp((m_V(v, axis) - m_Corner[axis]) / m_Side, -farthest, farthest)));
    }
    return cell;
  }

  const VertexMatrix &                      m_V;
  Eigen::RowVector3d                        m_Corner;
  double                                    m_Side;
  std::unordered_map<Cell, int, HashOfCell> m_First;
  std::vector<int>                          m_Next;
};

void
KeepRows(SurfaceMesh & mesh, const std::vector<int> & kept)
{
  for (std::size_t i = 0; i < kept.size(); ++i) // rows only move forward
  {
    mesh.V.row(static_cast<Eigen::Index>(i)) = mesh.V.row(kept[i]).eval();
    for (SurfaceArray & array : mesh.pointArrays)
    {
      array.values.row(static_cast<Eigen::Index>(i)) = array.values.row(kept[i]).eval();
    }
  }
  const auto rows = static_cast<Eigen::Index>(kept.size());
  mesh.V.conservativeResize(rows, Eigen::NoChange);
  for (SurfaceArray & array : mesh.pointArrays)
  {
    array.values.conservativeResize(rows, Eigen::NoChange);
  }
}
} // namespace

std::vector<int>
FirstAtPosition(const SurfaceMesh & mesh, double distance)
{
  const auto       corners = CornersOfFaces(mesh);
  const double     tolerance = CoincidentPositions * (corners[1] - corners[0]).maxCoeff();
  const double     reach = std::max({ distance, tolerance, std::numeric_limits<double>::min() });
  constexpr double cells = 1000.0;        // tolerances per side of a cell; few vertices then lie near another cell
  DisjointSets     groups(mesh.V.rows()); // represented by the lowest vertex
  VertexCells      placed(mesh, std::max(reach, cells * tolerance));
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (mesh.V.row(v).allFinite()) // others belong to no face
    {
      placed.VisitNear(v, reach, [&](int w) {
        if ((mesh.V.row(w) - mesh.V.row(v)).squaredNorm() <= reach * reach)
        {
          groups.Join(w, v);
        }
      });
      placed.Add(v);
    }
  }
  std::vector<int> first(mesh.V.rows());
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    first[v] = groups.Find(v); // at most v
  }
  return first;
}

int
MergeVertices(SurfaceMesh & mesh, double distance)
{
  const std::vector<int> firsts = FirstAtPosition(mesh, distance);
  std::vector<int>       newIndex(mesh.V.rows());
  std::vector<int>       kept;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (firsts[v] == v)
    {
      newIndex[v] = static_cast<int>(kept.size());
      kept.push_back(v);
    }
    else
    {
      newIndex[v] = newIndex[firsts[v]];
    }
  }
  const int merged = mesh.NumberOfVertices() - static_cast<int>(kept.size());
  if (merged > 0)
  {
    for (Eigen::Index i = 0; i < mesh.F.size(); ++i)
    {
      mesh.F.data()[i] = newIndex[mesh.F.data()[i]];
    }
    KeepRows(mesh, kept);
  }
  return merged;
}
} // namespace shapeton
