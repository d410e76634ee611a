#ifndef shapetonConductanceField_h
#define shapetonConductanceField_h

#include "shapetonPaddedGrid.h"
#include "shapetonVolumeGradientOperator.h"

#include <algorithm>
#include <array>
#include <vector>

namespace shapeton
{
/** An edge from an unseeded voxel to a seed, or to the label that it has before, which supplies heat. */
struct SeedEdge
{
  std::size_t    voxel; ///< its index on the padded grid
  unsigned short label;
  float          conductance;
};

/** The conductances of a volume without the seeded voxels; edges to them become leaks of their neighbors, as does a
 * weak edge to the label that a voxel has before, if it has one. The border of the volume is insulated. Nodes are
 * indices on the padded grid. */
struct ConductanceField
{
  PaddedGrid                 grid;
  std::array<PaddedField, 3> conductances; ///< entry i belongs to the edge from voxel i to its successor
  PaddedField                leak;
  std::array<double, 3>      spacing{}; ///< relative to the smallest one
  std::vector<SeedEdge>      seedEdges;

  /** \param before the labels before; null: none */
  ConductanceField(const VolumeGradientOperator & volumeGradient,
                   const unsigned short *         seeds,
                   const unsigned short *         before);

  // Interface of a level in a hierarchy of graphs, shared by the finest level and all others.

  std::array<std::size_t, 3>
  GetCells() const
  {
    return grid.GetSize();
  }
  const std::array<double, 3> &
  GetSpacing() const
  {
    return spacing;
  }
  std::size_t
  GetNumberOfPlaces() const
  {
    return grid.GetLength();
  }
  float
  GetLeak(std::size_t node) const
  {
    return leak.GetData()[node];
  }

  /** Calls body(neighbor, conductance) for the edges of a node. */
  template <typename TBody>
  void
  ForEachEdge(std::size_t node, const TBody & body) const
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const float * const c = conductances[axis].GetData();
      const std::size_t   stride = grid.GetStride(axis);
      if (c[node - stride] > 0.0F)
      {
        body(node - stride, c[node - stride]);
      }
      if (c[node] > 0.0F)
      {
        body(node + stride, c[node]);
      }
    }
  }

  /** Calls body(node, column, row) for the nodes of a slice that have an edge or a leak. */
  template <typename TBody>
  void
  ForEachNode(std::size_t slice, const TBody & body) const
  {
    for (std::size_t y = 0; y < grid.GetSize()[1]; ++y)
    {
      const std::size_t row = grid.GetRow(static_cast<std::ptrdiff_t>(y), static_cast<std::ptrdiff_t>(slice));
      for (std::size_t x = 0; x < grid.GetSize()[0]; ++x)
      {
        if (this->IsNode(row + x))
        {
          body(row + x, x, y);
        }
      }
    }
  }

  /** Nodes of slices [first, end) have these indices. */
  std::array<std::size_t, 2>
  GetPlacesOfSlices(std::size_t first, std::size_t end) const
  {
    return { { grid.GetRow(-1, static_cast<std::ptrdiff_t>(first)),
               grid.GetRow(-1, static_cast<std::ptrdiff_t>(end)) } };
  }

private:
  bool
  IsNode(std::size_t place) const
  {
    return leak.GetData()[place] > 0.0F || std::any_of(conductances.begin(), conductances.end(), [&](const auto & c) {
             return c.GetData()[place] > 0.0F || c.GetData()[place - grid.GetStride(&c - conductances.data())] > 0.0F;
           });
  }
};
} // namespace shapeton

#endif
