#include "shapetonLumenGrid.h"

#include "shapetonInterruption.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
/** Mean distance to the wall in a block of voxels of one component; `component` is 0 if any voxel is not lumen. */
struct BlockContent
{
  float distance{ 0.0F };
  int   component{ 0 };
};

BlockContent
ReadBlock(const LumenDistanceImage * distance,
          const LumenLabelImage *    labels,
          std::size_t                first,
          const std::array<int, 3> & block)
{
  const auto   size = labels->GetBufferedRegion().GetSize();
  BlockContent content;
  for (int z = 0; z < block[2]; ++z)
  {
    for (int y = 0; y < block[1]; ++y)
    {
      const std::size_t row = first + (z * size[1] + y) * size[0];
      for (int x = 0; x < block[0]; ++x)
      {
        const int component = labels->GetBufferPointer()[row + x];
        if (component == 0)
        {
          return {};
        }
        content.component = component;
        content.distance += distance->GetBufferPointer()[row + x];
      }
    }
  }
  content.distance /= static_cast<float>(block[0] * block[1] * block[2]);
  return content;
}
} // namespace

std::array<int, 3>
LumenGrid::Blocks(const itk::SpacePrecisionType * spacing)
{
  constexpr double   coarsest = 1.75; // mm
  std::array<int, 3> blocks;
  for (int a = 0; a < 3; ++a)
  {
    blocks[a] = std::max(1, static_cast<int>(std::floor(coarsest / spacing[a])));
  }
  return blocks;
}

LumenGrid::LumenGrid(const LumenDistanceImage * distance,
                     const LumenLabelImage *    labels,
                     const std::vector<char> &  isUsed,
                     const std::array<int, 3> & block)
  : m_Block(block)
{
  const auto         region = distance->GetBufferedRegion();
  std::array<int, 3> size;
  for (int a = 0; a < 3; ++a)
  {
    // One empty layer all around, so every node has 26 neighbors.
    size[a] = static_cast<int>(region.GetSize(a)) / block[a] + 2;
    m_Spacing[a] = block[a] * distance->GetSpacing()[a];
    m_First[a] = 0.5 * (block[a] - 1) * distance->GetSpacing()[a] - m_Spacing[a];
    for (int b = 0; b < 3; ++b)
    {
      m_Direction(a, b) = distance->GetDirection()(a, b);
    }
  }
  m_Grid.SetSize(size);
  const auto origin = distance->TransformIndexToPhysicalPoint<itk::SpacePrecisionType>(region.GetIndex());
  m_Origin = Eigen::Vector3d(origin[0], origin[1], origin[2]);
  this->MakeNodes(distance, labels, isUsed);
  this->FindNeighbors();
}

void
LumenGrid::MakeNodes(const LumenDistanceImage * distance,
                     const LumenLabelImage *    labels,
                     const std::vector<char> &  isUsed)
{
  const auto size = labels->GetBufferedRegion().GetSize();
  m_NodeAt.assign(m_Grid.NumberOfVoxels(), -1);
  for (int z = 1; z < m_Grid.size[2] - 1; ++z)
  {
    Interruption::Check();
    for (int y = 1; y < m_Grid.size[1] - 1; ++y)
    {
      for (int x = 1; x < m_Grid.size[0] - 1; ++x)
      {
        const std::size_t first =
          ((z - 1) * m_Block[2] * size[1] + (y - 1) * m_Block[1]) * size[0] + (x - 1) * m_Block[0];
        const BlockContent content = ReadBlock(distance, labels, first, m_Block);
        if (isUsed[content.component])
        {
          const int voxel = static_cast<int>(m_Grid.Index(x, y, z));
          m_NodeAt[voxel] = static_cast<int>(m_Voxels.size());
          m_Voxels.push_back(voxel);
          m_Distances.push_back(content.distance);
          m_Components.push_back(content.component);
        }
      }
    }
  }
}

void
LumenGrid::FindNeighbors()
{
  std::array<std::ptrdiff_t, 27> offsets;
  for (int step = 0; step < 27; ++step)
  {
    const std::array<int, 3> way = { step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1 };
    offsets[step] = m_Grid.Offset(way[0], way[1], way[2]);
    m_StepLengths[step] = Eigen::Vector3d(way[0] * m_Spacing[0], way[1] * m_Spacing[1], way[2] * m_Spacing[2]).norm();
  }
  m_Neighbors.resize(m_Voxels.size());
  ParallelForBlocks(m_Voxels.size(), [&](std::size_t node) {
    Neighbors & around = m_Neighbors[node];
    for (int step = 26; step >= 0; --step)
    {
      const int neighbor = m_NodeAt[m_Voxels[node] + offsets[step]];
      if (neighbor >= 0)
      {
        around.present |= 1U << step;
        around.firstOfRow[step / 3] = neighbor;
      }
    }
  });
}

int
LumenGrid::NodeOf(const Eigen::Vector3d & position) const
{
  std::array<int, 3> voxel;
  for (int a = 0; a < 3; ++a)
  {
    voxel[a] = static_cast<int>(std::lround((position[a] - m_First[a]) / m_Spacing[a]));
    if (voxel[a] < 0 || voxel[a] >= m_Grid.size[a])
    {
      return -1;
    }
  }
  return this->NodeAt(voxel[0], voxel[1], voxel[2]);
}

int
LumenGrid::NearestNode(const Eigen::Vector3d & position) const
{
  int    nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int node = 0; node < this->NumberOfNodes(); ++node)
  {
    const double d = (this->Position(node) - position).squaredNorm();
    if (d < least)
    {
      least = d;
      nearest = node;
    }
  }
  return nearest;
}
} // namespace shapeton
