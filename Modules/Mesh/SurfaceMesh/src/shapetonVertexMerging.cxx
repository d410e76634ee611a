#include "shapetonVertexMerging.h"

#include "shapetonDisjointSets.h"

#include <array>
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

/** Equal positions, hashed by their bits; -0 equals 0. */
void
JoinEqual(const VertexMatrix & V, DisjointSets<> & groups)
{
  std::unordered_map<Cell, int, HashOfCell> first;
  first.reserve(V.rows());
  for (int v = 0; v < V.rows(); ++v)
  {
    Cell key;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double value = V(v, axis) + 0.0;
      static_assert(sizeof(value) == sizeof(key[0]), "a double has 64 bits");
      std::copy_n(reinterpret_cast<const char *>(&value), sizeof(value), reinterpret_cast<char *>(&key[axis]));
    }
    const auto [place, isNew] = first.emplace(key, v);
    if (!isNew)
    {
      groups.Join(place->second, v);
    }
  }
}

/** Close positions: each vertex is compared with those in the 27 surrounding cells of side `distance`. */
void
JoinNear(const VertexMatrix & V, double distance, DisjointSets<> & groups)
{
  const auto         isPosition = [&](int v) { return V.row(v).allFinite(); };
  Eigen::RowVector3d corner = Eigen::RowVector3d::Constant(std::numeric_limits<double>::infinity());
  for (int v = 0; v < V.rows(); ++v)
  {
    if (isPosition(v))
    {
      corner = corner.cwiseMin(V.row(v));
    }
  }
  std::unordered_map<Cell, std::vector<int>, HashOfCell> cells;
  for (int v = 0; v < V.rows(); ++v)
  {
    if (!isPosition(v))
    {
      continue;
    }
    constexpr double farthest = 1e15;
    Cell             own;
    for (int axis = 0; axis < 3; ++axis)
    {
      // Far cells are clamped: they only become larger, and all their vertices are compared.
      own[axis] = static_cast<std::int64_t>(std::min((V(v, axis) - corner[axis]) / distance, farthest));
    }
    for (int i = 0; i < 27; ++i)
    {
      const auto near = cells.find({ own[0] + i % 3 - 1, own[1] + i / 3 % 3 - 1, own[2] + i / 9 - 1 });
      for (std::size_t k = 0; near != cells.end() && k < near->second.size(); ++k)
      {
        if ((V.row(near->second[k]) - V.row(v)).squaredNorm() <= distance * distance)
        {
          groups.Join(near->second[k], v);
        }
      }
    }
    cells[own].push_back(v);
  }
}

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

int
MergeVertices(SurfaceMesh & mesh, double distance)
{
  DisjointSets groups(mesh.V.rows()); // represented by the lowest vertex
  JoinEqual(mesh.V, groups);
  if (distance > 0.0)
  {
    JoinNear(mesh.V, distance, groups);
  }
  std::vector<int> newIndex(mesh.V.rows());
  std::vector<int> kept;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const int first = groups.Find(v); // at most v
    if (first == v)
    {
      newIndex[v] = static_cast<int>(kept.size());
      kept.push_back(v);
    }
    else
    {
      newIndex[v] = newIndex[first];
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
