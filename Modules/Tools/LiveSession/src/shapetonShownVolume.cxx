#include "shapetonShownVolume.h"

#include "shapetonParallelFor.h"

#include <algorithm>

namespace shapeton
{
namespace
{
std::uint16_t
BinOf(double value)
{
  return static_cast<std::uint16_t>(HeatHistogram::BinOf(static_cast<float>(value)));
}

/** Bins of small numbers of visits, which are the most frequent ones. */
class BinsOfCounts
{
public:
  explicit BinsOfCounts(double scale) : m_Scale(scale)
  {
    for (std::size_t count = 0; count < m_Bins.size(); ++count)
    {
      m_Bins[count] = BinOf(scale * static_cast<double>(count));
    }
  }

  std::uint16_t
  Of(std::uint64_t count) const
  {
    return count < m_Bins.size() ? m_Bins[count] : BinOf(m_Scale * static_cast<double>(count));
  }

private:
  double                          m_Scale;
  std::array<std::uint16_t, 4096> m_Bins{};
};
} // namespace

std::array<std::size_t, 3>
ReducedSize(const std::array<std::size_t, 3> & size, std::size_t stride)
{
  std::array<std::size_t, 3> reduced{};
  std::transform(size.begin(), size.end(), reduced.begin(), [&](std::size_t n) { return (n + stride - 1) / stride; });
  return reduced;
}

ShownVolume::ShownVolume(const std::array<std::size_t, 3> & size, const std::uint32_t * visits, std::uint32_t greatest)
  : m_Size(size), m_Visits(visits), m_Scale(1.0 / std::max(1U, greatest))
{}

ShownVolume::ShownVolume(const std::array<std::size_t, 3> & size, const float * heat) : m_Size(size), m_Heat(heat) {}

ShownVolume::ShownVolume(const std::array<std::size_t, 3> & size, const BlockValues & heat)
  : m_Size(size), m_Blocks(&heat)
{}

float
ShownVolume::GetValue(std::size_t x, std::size_t y, std::size_t z) const
{
  const auto at = [&](const std::array<std::size_t, 3> & size, std::size_t f) {
    return (z / f * size[1] + y / f) * size[0] + x / f;
  };
  return m_Visits ? static_cast<float>(m_Scale * m_Visits[at(m_Size, 1)])
         : m_Heat ? m_Heat[at(m_Size, 1)]
                  : m_Blocks->values[at(m_Blocks->size, m_Blocks->factor)];
}

HeatBins
ShownVolume::ReducedVisits(std::size_t stride) const
{
  const auto         size = ReducedSize(m_Size, stride);
  const BinsOfCounts binsOf(m_Scale / static_cast<double>(stride * stride * stride));
  HeatBins           bins(size[0] * size[1] * size[2]);
  ParallelFor(size[2], [&](std::size_t k) {
    std::vector<std::uint64_t> sums(size[0]);
    for (std::size_t j = 0; j < size[1]; ++j)
    {
      std::fill(sums.begin(), sums.end(), 0);
      for (std::size_t z = stride * k; z < std::min(stride * (k + 1), m_Size[2]); ++z)
      {
        for (std::size_t y = stride * j; y < std::min(stride * (j + 1), m_Size[1]); ++y)
        {
          const std::uint32_t * const row = m_Visits + (z * m_Size[1] + y) * m_Size[0];
          for (std::size_t i = 0, x = 0; i < size[0]; ++i)
          {
            for (const std::size_t end = std::min(x + stride, m_Size[0]); x < end; ++x)
            {
              sums[i] += row[x];
            }
          }
        }
      }
      std::transform(sums.begin(),
                     sums.end(),
                     bins.begin() + static_cast<std::ptrdiff_t>((k * size[1] + j) * size[0]),
                     [&](std::uint64_t sum) { return binsOf.Of(sum); });
    }
  });
  return bins;
}

HeatBins
ShownVolume::Reduced(std::size_t stride) const
{
  if (m_Visits)
  {
    return this->ReducedVisits(stride);
  }
  const auto size = ReducedSize(m_Size, stride);
  HeatBins   bins(size[0] * size[1] * size[2]);
  const auto middle = [&](std::size_t i, unsigned int axis) {
    return std::min(stride * i + stride / 2, m_Size[axis] - 1);
  };
  ParallelFor(size[2], [&](std::size_t k) {
    std::uint16_t * bin = bins.data() + k * size[0] * size[1];
    for (std::size_t j = 0; j < size[1]; ++j)
    {
      for (std::size_t i = 0; i < size[0]; ++i)
      {
        *bin++ = BinOf(this->GetValue(middle(i, 0), middle(j, 1), middle(k, 2)));
      }
    }
  });
  return bins;
}

std::vector<float>
ShownVolume::Values() const
{
  std::vector<float> values(m_Size[0] * m_Size[1] * m_Size[2]);
  ParallelFor(m_Size[2], [&](std::size_t z) {
    float * value = values.data() + z * m_Size[0] * m_Size[1];
    for (std::size_t y = 0; y < m_Size[1]; ++y)
    {
      for (std::size_t x = 0; x < m_Size[0]; ++x)
      {
        *value++ = this->GetValue(x, y, z);
      }
    }
  });
  return values;
}

HeatBins
ShownVolume::Slice(unsigned int axis, std::size_t at) const
{
  const unsigned int         across = axis == 0 ? 1 : 0;
  const unsigned int         down = axis == 2 ? 1 : 2;
  HeatBins                   bins;
  std::array<std::size_t, 3> index{};
  index[axis] = at;
  bins.reserve(m_Size[across] * m_Size[down]);
  for (index[down] = 0; index[down] < m_Size[down]; ++index[down])
  {
    for (index[across] = 0; index[across] < m_Size[across]; ++index[across])
    {
      bins.push_back(BinOf(this->GetValue(index[0], index[1], index[2])));
    }
  }
  return bins;
}
} // namespace shapeton
