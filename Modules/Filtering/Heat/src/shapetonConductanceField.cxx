#include "shapetonConductanceField.h"

#include "shapetonParallelFor.h"
#include "shapetonSeededHeatSolver.h"

namespace shapeton
{
namespace
{
/** Removes the edges of seeds in one slice; each edge belongs to its lower voxel. */
class SeedCutter
{
public:
  SeedCutter(const VolumeGradientOperator & volumeGradient, const unsigned short * seeds)
    : m_VolumeGradient(volumeGradient), m_Size(volumeGradient.GetGrid().GetSize()), m_Seeds(seeds)
  {}

  /** The conductance of the edge from a voxel to its successor; 0 at the border. */
  float
  GetConductance(const std::array<std::size_t, 3> & voxel, unsigned int axis, std::size_t place) const
  {
    return voxel[axis] + 1 < m_Size[axis] ? m_VolumeGradient.GetConductances(axis)[place] : 0.0F;
  }

  unsigned short
  GetSeed(const std::array<std::size_t, 3> & voxel) const
  {
    return m_Seeds[(voxel[2] * m_Size[1] + voxel[1]) * m_Size[0] + voxel[0]];
  }

private:
  const VolumeGradientOperator & m_VolumeGradient;
  std::array<std::size_t, 3>     m_Size;
  const unsigned short *         m_Seeds;
};
} // namespace

ConductanceField::ConductanceField(const VolumeGradientOperator & volumeGradient,
                                   const unsigned short *         seeds,
                                   const unsigned short *         before)
  : grid(volumeGradient.GetGrid()), leak(grid)
{
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    spacing[axis] = volumeGradient.GetResolution(axis);
    conductances[axis] = PaddedField(grid);
  }
  const SeedCutter                   cutter(volumeGradient, seeds);
  const auto                         size = grid.GetSize();
  std::vector<std::vector<SeedEdge>> edges(size[2]);
  std::vector<std::vector<SeedEdge>> upwards(size[2]); // edges of a voxel of the next slice to a seed of this one
  ParallelFor(size[2], [&](std::size_t z) {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      const std::size_t row = grid.GetRow(static_cast<std::ptrdiff_t>(y), static_cast<std::ptrdiff_t>(z));
      for (std::size_t x = 0; x < size[0]; ++x)
      {
        const std::array<std::size_t, 3> voxel{ { x, y, z } };
        const unsigned short             seed = cutter.GetSeed(voxel);
        const unsigned short             known = seed == 0 && before ? before[(z * size[1] + y) * size[0] + x] : 0;
        if (known != 0)
        {
          edges[z].push_back({ row + x, known, SeededHeatSolver::ConductanceToLabelBefore });
        }
        for (unsigned int axis = 0; axis < 3; ++axis)
        {
          const float conductance = cutter.GetConductance(voxel, axis, row + x);
          if (!(conductance > 0.0F))
          {
            continue;
          }
          auto successor = voxel;
          ++successor[axis];
          const unsigned short other = cutter.GetSeed(successor);
          if (seed == 0 && other == 0)
          {
            conductances[axis].GetData()[row + x] = conductance;
          }
          else if (seed == 0)
          {
            edges[z].push_back({ row + x, other, conductance });
          }
          else if (other == 0)
          {
            (axis == 2 ? upwards : edges)[z].push_back({ row + x + grid.GetStride(axis), seed, conductance });
          }
        }
      }
    }
  });
  for (auto * part : { &edges, &upwards })
  {
    for (const auto & slice : *part)
    {
      seedEdges.insert(seedEdges.end(), slice.begin(), slice.end());
    }
  }
  for (const SeedEdge & edge : seedEdges)
  {
    leak.GetData()[edge.voxel] += edge.conductance;
  }
}
} // namespace shapeton
