#ifndef shapetonLumenGrid_h
#define shapetonLumenGrid_h

#include "shapetonLumenDistance.h"
#include "shapetonVoxelGrid.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace shapeton
{
/** \class LumenGrid
 * \brief The lumen as nodes 0, 1, ..., in image order, on a grid with a spacing of at most about 1.7 mm.
 *
 * Finer voxels are merged into blocks. A block is lumen only if all of its voxels are, so that walls do not vanish.
 * Positions are in mm along the image axes, from the first voxel of the region; ToPhysical() converts to LPS.
 */
class LumenGrid
{
public:
  /** Nodes are the voxels whose component is true in `isUsed` (indexed from 1); `block` is the number of voxels per
   * node along each axis. */
  LumenGrid(const LumenDistanceImage * distance,
            const LumenLabelImage *    labels,
            const std::vector<char> &  isUsed,
            const std::array<int, 3> & block);

  /** Block size along each axis for voxels of at most 1.75 mm. */
  static std::array<int, 3>
  Blocks(const itk::SpacePrecisionType * spacing);

  int
  NumberOfNodes() const
  {
    return static_cast<int>(m_Voxels.size());
  }
  /** Distance to the wall, mm. */
  float
  Distance(int node) const
  {
    return m_Distances[node];
  }
  /** Component number of the node, from 1. */
  int
  Component(int node) const
  {
    return m_Components[node];
  }
  /** Neighboring node, or -1. `offset` is one of Strides(), or its negative. */
  int
  Neighbor(int node, int offset) const
  {
    return m_NodeAt[m_Voxels[node] + offset];
  }
  /** The voxel of a node. */
  std::array<int, 3>
  Voxel(int node) const
  {
    return m_Grid.Voxel(m_Voxels[node]);
  }
  /** Node of a voxel, or -1. */
  int
  NodeAt(int x, int y, int z) const
  {
    return m_NodeAt[m_Grid.Index(x, y, z)];
  }
  const std::array<int, 3> &
  Size() const
  {
    return m_Grid.size;
  }
  Eigen::Vector3d
  Position(int node) const
  {
    const auto voxel = this->Voxel(node);
    return m_First + m_Spacing.cwiseProduct(Eigen::Vector3d(voxel[0], voxel[1], voxel[2]));
  }
  double
  NodeVolume() const
  {
    return m_Spacing.prod();
  }
  const Eigen::Vector3d &
  Spacing() const
  {
    return m_Spacing;
  }

  /** Calls `body(neighbor, length)` in order for the nodes among the 26 neighbors; `length` is the step in mm. */
  template <typename TBody>
  void
  ForEachNeighbor(int node, const TBody & body) const
  {
    constexpr unsigned int rowMask = 0b111; // the three neighbors of a row
    const Neighbors &      around = m_Neighbors[node];
    for (unsigned int row = 0; row < 9; ++row)
    {
      int          next = around.firstOfRow[row];
      unsigned int present = around.present >> (3 * row) & rowMask;
      for (unsigned int step = 3 * row; present != 0; ++step, present >>= 1)
      {
        if (present & 1U)
        {
          if (next != node)
          {
            body(next, m_StepLengths[step]);
          }
          ++next;
        }
      }
    }
  }
  /** Strides to the next voxel along x, y, z. */
  std::array<int, 3>
  Strides() const
  {
    return { 1, static_cast<int>(m_Grid.stride[1]), static_cast<int>(m_Grid.stride[2]) };
  }

  Eigen::Vector3d
  ToPhysical(const Eigen::Vector3d & position) const
  {
    return m_Origin + m_Direction * position;
  }
  Eigen::Vector3d
  FromPhysical(const Eigen::Vector3d & point) const
  {
    return m_Direction.transpose() * (point - m_Origin);
  }
  /** The node whose voxel contains a position; -1 outside the lumen. */
  int
  NodeOf(const Eigen::Vector3d & position) const;
  /** The node nearest to a position; -1 if there are no nodes. */
  int
  NearestNode(const Eigen::Vector3d & position) const;

private:
  void
  MakeNodes(const LumenDistanceImage * distance, const LumenLabelImage * labels, const std::vector<char> & isUsed);
  void
  FindNeighbors();

  /** A node and its neighbors, stored together for cache locality in path searches. Neighbors in a row have consecutive
   * numbers, so only the first of each of the nine rows is stored. */
  struct Neighbors
  {
    std::uint32_t      present{ 0 }; ///< bit x + 3 y + 9 z for the voxel at offset (x - 1, y - 1, z - 1)
    std::array<int, 9> firstOfRow;
  };

  std::array<int, 3> m_Block;
  VoxelGrid          m_Grid;
  Eigen::Vector3d    m_Spacing;
  /** The position of voxel 0. */
  Eigen::Vector3d        m_First;
  Eigen::Vector3d        m_Origin;
  Eigen::Matrix3d        m_Direction;
  std::vector<int>       m_NodeAt;
  std::vector<int>       m_Voxels;
  std::vector<float>     m_Distances;
  std::vector<int>       m_Components;
  std::array<double, 27> m_StepLengths; ///< mm
  std::vector<Neighbors> m_Neighbors;
};
} // namespace shapeton

#endif
