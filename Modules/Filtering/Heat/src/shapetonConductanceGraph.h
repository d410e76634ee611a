#ifndef shapetonConductanceGraph_h
#define shapetonConductanceGraph_h

#include "shapetonConductanceField.h"
#include "shapetonVoxelValues.h"

#include <array>
#include <cstdint>
#include <vector>

namespace shapeton
{
/** A coarse level of the hierarchy. Its nodes are aggregates of nodes of the finer level, joined by the sums of
 * their conductances (Galerkin operator for piecewise constant values). Nodes are sorted by the slice of their
 * cells; edges join nodes of the same or of adjacent slices. */
struct ConductanceGraph
{
  template <typename T>
  using OfEdges = std::vector<T, UninitializedAllocator<T>>;

  std::vector<std::uint64_t>                firstEdge; ///< for each node, then the number of all edges
  OfEdges<std::uint32_t>                    neighbors;
  OfEdges<float>                            conductances;
  std::vector<float>                        leak;
  std::vector<float>                        inverse; ///< 1 / (leak + sum of conductances)
  std::vector<std::uint64_t>                firstOfSlice;
  std::vector<std::array<std::uint16_t, 2>> cellOf; ///< column and row of the cell
  std::array<std::size_t, 3>                cells{};
  std::array<double, 3>                     spacing{};

  std::size_t
  GetNumberOfNodes() const
  {
    return leak.size();
  }
  std::array<std::size_t, 3>
  GetCells() const
  {
    return cells;
  }
  const std::array<double, 3> &
  GetSpacing() const
  {
    return spacing;
  }
  std::size_t
  GetNumberOfPlaces() const
  {
    return leak.size();
  }
  float
  GetLeak(std::size_t node) const
  {
    return leak[node];
  }
  template <typename TBody>
  void
  ForEachEdge(std::size_t node, const TBody & body) const
  {
    for (std::uint64_t edge = firstEdge[node]; edge < firstEdge[node + 1]; ++edge)
    {
      body(neighbors[edge], conductances[edge]);
    }
  }
  template <typename TBody>
  void
  ForEachNode(std::size_t slice, const TBody & body) const
  {
    for (std::uint64_t node = firstOfSlice[slice]; node < firstOfSlice[slice + 1]; ++node)
    {
      body(node, cellOf[node][0], cellOf[node][1]);
    }
  }
  std::array<std::size_t, 2>
  GetPlacesOfSlices(std::size_t first, std::size_t end) const
  {
    return { { firstOfSlice[first], firstOfSlice[end] } };
  }
};

/** Aggregate of an index that is not a node. */
constexpr std::uint32_t noAggregate = ~std::uint32_t(0);

/** Computes the next coarser level. Aggregates are sets joined by strong edges within cells of two nodes along each
 * axis, or of one node along an axis whose spacing is more than 1.5 times the smallest. Unlike fixed boxes, aggregates
 * do not cross insulating edges. `aggregateOf` receives the aggregate of each node. Independent of the number of
 * threads. TLevel is ConductanceField or ConductanceGraph. */
template <typename TLevel>
ConductanceGraph
Coarsen(const TLevel & level, std::vector<std::uint32_t> & aggregateOf);

extern template ConductanceGraph
Coarsen(const ConductanceField &, std::vector<std::uint32_t> &);
extern template ConductanceGraph
Coarsen(const ConductanceGraph &, std::vector<std::uint32_t> &);
} // namespace shapeton

#endif
