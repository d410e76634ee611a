#include "ReferenceParts.h"

#include "shapetonImageGrid.h"
#include "shapetonSquaredDistances.h"

#include <algorithm>
#include <numeric>

using namespace shapeton;

namespace
{
/** Whether two labels touch by a face. */
std::vector<std::vector<char>>
TouchingLabels(const ReferenceParts::Labels * labels, const VoxelGrid & grid, std::size_t number)
{
  std::vector<std::vector<char>> touches(number, std::vector<char>(number, 0));
  const auto * const             values = labels->GetBufferPointer();
  for (std::size_t voxel = 0; voxel < grid.NumberOfVoxels(); ++voxel)
  {
    ForEachNeighbor(grid, voxel, [&](std::size_t neighbor) { touches[values[voxel]][values[neighbor]] = 1; });
  }
  return touches;
}

double
Sum(const double * counts, int label, const std::vector<int> & others)
{
  return std::accumulate(
    others.begin(), others.end(), counts[label], [&](double sum, int other) { return sum + counts[other]; });
}
} // namespace

ReferenceParts::ReferenceParts(const Labels * labels) : m_Labels(labels), m_Grid(GridOf(labels))
{
  constexpr double least = 300.0;
  const double     most = HeatObjectOptions{}.mostShare * static_cast<double>(m_Grid.NumberOfVoxels());
  const auto *     first = labels->GetBufferPointer();
  const auto       last = first + m_Grid.NumberOfVoxels();
  m_Totals.assign(*std::max_element(first, last) + std::size_t{ 1 }, 0.0);
  std::for_each(first, last, [&](unsigned char label) { m_Totals[label] += 1.0; });
  const auto touches = TouchingLabels(labels, m_Grid, m_Totals.size());
  m_Enclosed.resize(m_Totals.size());
  for (int label = 1; label < static_cast<int>(m_Totals.size()); ++label)
  {
    m_Enclosed[label] = this->EnclosedBy(label, touches);
    if (m_Totals[label] >= least && m_Totals[label] <= most)
    {
      m_Parts.push_back(label);
    }
  }
}

std::vector<int>
ReferenceParts::EnclosedBy(int label, const std::vector<std::vector<char>> & touches) const
{
  std::vector<char> isReached(touches.size(), 0);
  isReached[label] = 1;
  std::vector<int> open{ 0 };
  while (!open.empty())
  {
    const int here = open.back();
    open.pop_back();
    isReached[here] = 1;
    for (std::size_t other = 0; other < touches.size(); ++other)
    {
      if (touches[here][other] != 0 && isReached[other] == 0)
      {
        isReached[other] = 1;
        open.push_back(static_cast<int>(other));
      }
    }
  }
  std::vector<int> enclosed;
  for (std::size_t other = 0; other < touches.size(); ++other)
  {
    if (isReached[other] == 0 && m_Totals[other] > 0.0)
    {
      enclosed.push_back(static_cast<int>(other));
    }
  }
  return enclosed;
}

double
ReferenceParts::Dice(int part, const double * counts, double size) const
{
  const auto & enclosed = m_Enclosed[part];
  const double alone = 2.0 * counts[part] / (size + m_Totals[part]);
  return std::max(alone, 2.0 * Sum(counts, part, enclosed) / (size + Sum(m_Totals.data(), part, enclosed)));
}

double
ReferenceParts::BestDice(const double * counts, double size) const
{
  return std::accumulate(m_Parts.begin(), m_Parts.end(), 0.0, [&](double best, int part) {
    return std::max(best, this->Dice(part, counts, size));
  });
}

ReferenceParts::Depths
ReferenceParts::DepthsOf(int part) const
{
  Depths             depths;
  std::array<int, 3> low = m_Grid.size;
  std::array<int, 3> high{ { 0, 0, 0 } }; // a box with the part and, within the volume, a voxel on each side
  for (std::size_t voxel = 0; voxel < m_Grid.NumberOfVoxels(); ++voxel)
  {
    if (this->LabelOf(voxel) == part)
    {
      depths.voxels.push_back(voxel);
      const auto place = m_Grid.Voxel(voxel);
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], std::max(place[axis] - 1, 0));
        high[axis] = std::max(high[axis], std::min(place[axis] + 2, m_Grid.size[axis]));
      }
    }
  }
  const VoxelGrid box(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  const auto      inBox = [&](std::size_t voxel) {
    const auto place = m_Grid.Voxel(voxel);
    return box.Index(place[0] - low[0], place[1] - low[1], place[2] - low[2]);
  };
  std::vector<unsigned char> mask(box.NumberOfVoxels(), 0);
  for (const std::size_t voxel : depths.voxels)
  {
    mask[inBox(voxel)] = 1;
  }
  const auto squares = SquaredDistances(box, { { 1.0, 1.0, 1.0 } }, mask);
  std::transform(depths.voxels.begin(),
                 depths.voxels.end(),
                 std::back_inserter(depths.squares),
                 [&](std::size_t voxel) { return squares[inBox(voxel)]; });
  return depths;
}

ReferenceParts::Counts
CountsIn(const std::vector<VoxelRange> & ranges, const ReferenceParts & parts)
{
  ReferenceParts::Counts counts(parts.GetTotals().size(), 0.0);
  for (const VoxelRange & range : ranges)
  {
    for (std::uint32_t voxel = range.begin; voxel < range.end; ++voxel)
    {
      counts[parts.LabelOf(voxel)] += 1.0;
    }
  }
  return counts;
}
