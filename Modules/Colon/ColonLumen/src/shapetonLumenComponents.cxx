#include "shapetonLumenDistance.h"

#include "shapetonDisjointSets.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <numeric>

namespace shapeton
{
namespace
{
/** Neighbouring lumen voxels of one row. */
struct Run
{
  std::int32_t first, last;
  std::int32_t y, z;
};

class Runs
{
public:
  Runs(const LumenMask * lumen, const itk::ImageRegion<3> & region)
  {
    const auto size = region.GetSize();
    m_RowBegin.reserve(size[1] * size[2] + 1);
    for (std::size_t z = 0; z < size[2]; ++z)
    {
      for (std::size_t y = 0; y < size[1]; ++y)
      {
        m_RowBegin.push_back(m_Runs.size());
        const itk::Index<3> first = { { region.GetIndex(0),
                                        region.GetIndex(1) + static_cast<itk::IndexValueType>(y),
                                        region.GetIndex(2) + static_cast<itk::IndexValueType>(z) } };
        this->AddRow(lumen->GetBufferPointer() + lumen->ComputeOffset(first), size[0], y, z);
      }
    }
    m_RowBegin.push_back(m_Runs.size());
    m_Sets = DisjointSets<std::size_t>(m_Runs.size());
    for (std::size_t r = 0; r < size[1] * size[2]; ++r)
    {
      if (r % size[1] != 0)
      {
        this->JoinRows(r, r - 1);
      }
      if (r >= size[1])
      {
        this->JoinRows(r, r - size[1]);
      }
    }
  }

  const std::vector<Run> &
  Get() const
  {
    return m_Runs;
  }

  /** The first run of the component. */
  std::size_t
  Root(std::size_t run)
  {
    return m_Sets.Find(run);
  }

private:
  void
  AddRow(const unsigned char * voxels, std::size_t size, std::size_t y, std::size_t z)
  {
    for (std::size_t x = 0; x < size; ++x)
    {
      if (voxels[x] == 0)
      {
        continue;
      }
      const std::size_t first = x;
      while (x + 1 < size && voxels[x + 1] != 0)
      {
        ++x;
      }
      m_Runs.push_back({ static_cast<std::int32_t>(first),
                         static_cast<std::int32_t>(x),
                         static_cast<std::int32_t>(y),
                         static_cast<std::int32_t>(z) });
    }
  }

  void
  JoinRows(std::size_t rowA, std::size_t rowB)
  {
    std::size_t a = m_RowBegin[rowA];
    std::size_t b = m_RowBegin[rowB];
    while (a < m_RowBegin[rowA + 1] && b < m_RowBegin[rowB + 1])
    {
      if (m_Runs[a].first <= m_Runs[b].last && m_Runs[b].first <= m_Runs[a].last)
      {
        m_Sets.Join(a, b);
      }
      (m_Runs[a].last < m_Runs[b].last ? a : b)++;
    }
  }

  std::vector<Run>          m_Runs;
  std::vector<std::size_t>  m_RowBegin;
  DisjointSets<std::size_t> m_Sets;
};

void
Extend(LumenComponent & component, const Run & run, const itk::Index<3> & origin)
{
  const itk::Index<3> first = { { origin[0] + run.first, origin[1] + run.y, origin[2] + run.z } };
  const itk::Index<3> last = { { origin[0] + run.last, first[1], first[2] } };
  for (unsigned int a = 0; a < 3; ++a)
  {
    component.first[a] = component.voxels == 0 ? first[a] : std::min(component.first[a], first[a]);
    component.last[a] = component.voxels == 0 ? last[a] : std::max(component.last[a], last[a]);
  }
  component.voxels += run.last - run.first + 1;
}
} // namespace

LumenComponents
FindLumenComponents(const LumenMask * lumen, const itk::ImageRegion<3> & region)
{
  Runs                        runs(lumen, region);
  const std::vector<Run> &    all = runs.Get();
  std::vector<std::int32_t>   numberOf(all.size(), -1);
  std::vector<LumenComponent> found;
  for (std::size_t r = 0; r < all.size(); ++r)
  {
    const std::size_t root = runs.Root(r);
    if (root == r)
    {
      numberOf[r] = static_cast<std::int32_t>(found.size());
      found.emplace_back();
    }
    numberOf[r] = numberOf[root];
    Extend(found[numberOf[r]], all[r], region.GetIndex());
  }
  std::vector<std::size_t> order(found.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return found[a].voxels > found[b].voxels; });

  LumenComponents           result;
  std::vector<std::int32_t> labelOf(found.size());
  const auto                spacing = lumen->GetSpacing();
  for (const std::size_t component : order)
  {
    labelOf[component] = static_cast<std::int32_t>(result.components.size()) + 1;
    result.components.push_back(found[component]);
    result.components.back().volume = 1e-3 * spacing[0] * spacing[1] * spacing[2] * found[component].voxels;
  }
  result.labels = LumenLabelImage::New();
  result.labels->SetRegions(region);
  result.labels->SetSpacing(spacing);
  result.labels->SetOrigin(lumen->GetOrigin());
  result.labels->SetDirection(lumen->GetDirection());
  result.labels->Allocate(true);
  const auto size = region.GetSize();
  for (std::size_t r = 0; r < all.size(); ++r)
  {
    std::int32_t * const row = result.labels->GetBufferPointer() + (all[r].z * size[1] + all[r].y) * size[0];
    std::fill(row + all[r].first, row + all[r].last + 1, labelOf[numberOf[r]]);
  }
  return result;
}
} // namespace shapeton
