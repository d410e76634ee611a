#include "shapetonPaddedVoxels.h"

#include "shapetonDisjointSets.h"

namespace shapeton
{
namespace
{
/** Rows of runs, and how they are joined. */
class RunJoiner
{
public:
  RunJoiner(const PaddedVoxels & voxels, unsigned char flag, bool isSet) : m_Voxels(voxels)
  {
    m_RowBegin.reserve(static_cast<std::size_t>(voxels.ny * voxels.nz + 1));
    for (std::int64_t row = 0; row < voxels.ny * voxels.nz; ++row)
    {
      m_RowBegin.push_back(static_cast<int>(m_Runs.size()));
      this->FindRunsOfRow(row * voxels.nx, flag, isSet);
    }
    m_RowBegin.push_back(static_cast<int>(m_Runs.size()));
    m_Sets = DisjointSets(m_Runs.size());
  }

  void
  JoinAll(bool throughEdges)
  {
    const std::int64_t reach = throughEdges ? 1 : 0;
    for (std::int64_t z = 0; z < m_Voxels.nz; ++z)
    {
      for (std::int64_t y = 0; y < m_Voxels.ny; ++y)
      {
        this->JoinRows(y, z, y - 1, z, reach);
        this->JoinRows(y, z, y, z - 1, reach);
        if (throughEdges)
        {
          this->JoinRows(y, z, y - 1, z - 1, 0);
          this->JoinRows(y, z, y + 1, z - 1, 0);
        }
      }
    }
  }

  VoxelRuns
  Components()
  {
    VoxelRuns        result;
    std::vector<int> componentOfRoot(m_Runs.size(), -1);
    for (std::size_t i = 0; i < m_Runs.size(); ++i)
    {
      int & component = componentOfRoot[m_Sets.Find(static_cast<int>(i))];
      if (component < 0)
      {
        component = static_cast<int>(result.sizes.size());
        result.sizes.push_back(0);
      }
      m_Runs[i].component = component;
      result.sizes[component] += m_Runs[i].last - m_Runs[i].first + 1;
    }
    result.runs = std::move(m_Runs);
    return result;
  }

private:
  void
  FindRunsOfRow(std::int64_t begin, unsigned char flag, bool isSet)
  {
    const std::int64_t end = begin + m_Voxels.nx;
    const auto         belongs = [&](std::int64_t i) { return ((m_Voxels.flags[i] & flag) != 0) == isSet; };
    for (std::int64_t i = begin; i < end; ++i)
    {
      if (belongs(i))
      {
        const std::int64_t first = i;
        while (i + 1 < end && belongs(i + 1))
        {
          ++i;
        }
        m_Runs.push_back({ first, i, 0 });
      }
    }
  }

  void
  JoinRows(std::int64_t y, std::int64_t z, std::int64_t otherY, std::int64_t otherZ, std::int64_t reach)
  {
    if (otherY < 0 || otherZ < 0 || otherY >= m_Voxels.ny)
    {
      return;
    }
    const std::int64_t row = z * m_Voxels.ny + y;
    const std::int64_t other = otherZ * m_Voxels.ny + otherY;
    const std::int64_t shift = (row - other) * m_Voxels.nx;
    int                a = m_RowBegin[row];
    int                b = m_RowBegin[other];
    while (a < m_RowBegin[row + 1] && b < m_RowBegin[other + 1])
    {
      const std::int64_t first = m_Runs[b].first + shift;
      const std::int64_t last = m_Runs[b].last + shift;
      if (m_Runs[a].first <= last + reach && first <= m_Runs[a].last + reach)
      {
        m_Sets.Join(a, b);
      }
      (m_Runs[a].last < last ? a : b) += 1;
    }
  }

  const PaddedVoxels &        m_Voxels;
  std::vector<VoxelRuns::Run> m_Runs;
  std::vector<int>            m_RowBegin;
  DisjointSets<>              m_Sets;
};
} // namespace

VoxelRuns
FindVoxelRuns(const PaddedVoxels & voxels, unsigned char flag, bool isSet, bool throughEdges)
{
  RunJoiner joiner(voxels, flag, isSet);
  joiner.JoinAll(throughEdges);
  return joiner.Components();
}
} // namespace shapeton
