#include "shapetonClassifiedVolume.h"

#include "itkMultiThreaderBase.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace shapeton
{
namespace
{
constexpr float fullOpacity = 65535.0F;

void
ForEach(int number, const std::function<void(int)> & work)
{
  itk::MultiThreaderBase::New()->ParallelizeArray(
    0, number, [&](itk::SizeValueType i) { work(static_cast<int>(i)); }, nullptr);
}

/** The binomial kernel 1 2 1 along a line of values, in place; the ends repeat. */
void
SmoothLine(std::uint16_t * line, int length, std::size_t stride)
{
  std::uint32_t previous = line[0];
  for (int i = 0; i < length; ++i)
  {
    const std::uint32_t value = line[i * stride];
    const std::uint32_t next = line[(i + 1 < length ? i + 1 : i) * stride];
    line[i * stride] = static_cast<std::uint16_t>((previous + 2 * value + next + 2) / 4);
    previous = value;
  }
}

/** The two voxels around a coordinate, at the border one and the same, and the share of the second one. */
struct Neighbours
{
  int   first;
  int   second;
  float share;
};

Neighbours
NeighboursOf(double coordinate, int size)
{
  const double within = std::min(std::max(coordinate, 0.0), size - 1.0);
  const int    first = static_cast<int>(within);
  return { first, std::min(first + 1, size - 1), static_cast<float>(within - first) };
}
} // namespace

ClassifiedVolume::ClassifiedVolume(const itk::Image<float, 3> * heat, const ShapeTransferFunction & transferFunction)
{
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    m_Size[axis] = static_cast<int>(heat->GetBufferedRegion().GetSize(axis));
    m_Blocks[axis] = (m_Size[axis] + BlockSize - 1) / BlockSize;
  }
  this->Classify(heat, transferFunction);
  this->MarkOccupiedBlocks();
  this->MarkUniformBlocks();
  this->SmoothOpacity();
}

void
ClassifiedVolume::Classify(const itk::Image<float, 3> * heat, const ShapeTransferFunction & transferFunction)
{
  m_Samples.push_back(Sample{});
  for (const TransferFunctionLine & line : transferFunction.GetLines())
  {
    const auto opacity = static_cast<float>(line.opacity);
    m_Samples.push_back({ opacity * static_cast<float>(line.color[0]) / 255.0F,
                          opacity * static_cast<float>(line.color[1]) / 255.0F,
                          opacity * static_cast<float>(line.color[2]) / 255.0F,
                          opacity });
  }
  const std::size_t   slice = static_cast<std::size_t>(m_Size[0]) * m_Size[1];
  const float * const heats = heat->GetBufferPointer();
  m_Lines.resize(slice * m_Size[2]);
  m_SmoothOpacity.resize(m_Lines.size());
  ForEach(m_Size[2], [&](int z) {
    for (std::size_t i = z * slice; i < (z + 1) * slice; ++i)
    {
      m_Lines[i] = static_cast<std::uint8_t>(transferFunction.LineOf(heats[i]) + 1);
      m_SmoothOpacity[i] = static_cast<std::uint16_t>(m_Samples[m_Lines[i]][3] * fullOpacity + 0.5F);
    }
  });
}

std::size_t
ClassifiedVolume::BlockIndex(int x, int y, int z) const
{
  return (static_cast<std::size_t>(z) * m_Blocks[1] + y) * m_Blocks[0] + x;
}

void
ClassifiedVolume::MarkOccupiedBlocks()
{
  m_Content.assign(this->BlockIndex(0, 0, m_Blocks[2]), Content::Transparent);
  // A block looks one voxel beyond its borders, as far as interpolation does.
  ForEach(m_Blocks[2], [&](int blockZ) {
    const int firstZ = std::max(blockZ * BlockSize - 1, 0);
    const int endZ = std::min((blockZ + 1) * BlockSize + 1, m_Size[2]);
    for (int z = firstZ; z < endZ; ++z)
    {
      for (int y = 0; y < m_Size[1]; ++y)
      {
        for (int x = 0; x < m_Size[0]; ++x)
        {
          const std::uint8_t line = m_Lines[(static_cast<std::size_t>(z) * m_Size[1] + y) * m_Size[0] + x];
          if (m_Samples[line][3] == 0.0F)
          {
            continue;
          }
          for (const int nearY : { std::max(y - 1, 0), y, std::min(y + 1, m_Size[1] - 1) })
          {
            for (const int nearX : { std::max(x - 1, 0), x, std::min(x + 1, m_Size[0] - 1) })
            {
              m_Content[this->BlockIndex(nearX / BlockSize, nearY / BlockSize, blockZ)] = Content::Mixed;
            }
          }
        }
      }
    }
  });
}

void
ClassifiedVolume::MarkUniformBlocks()
{
  // A block and all its neighbours: they reach farther than the smoothing of opacity and the difference for the
  // gradient.
  constexpr std::uint8_t    several = 255;
  std::vector<std::uint8_t> lineOfBlock(m_Content.size());
  ForEach(m_Blocks[2], [&](int blockZ) {
    for (int z = blockZ * BlockSize; z < std::min((blockZ + 1) * BlockSize, m_Size[2]); ++z)
    {
      for (int y = 0; y < m_Size[1]; ++y)
      {
        for (int x = 0; x < m_Size[0]; ++x)
        {
          const bool     isFirst = z % BlockSize == 0 && y % BlockSize == 0 && x % BlockSize == 0;
          std::uint8_t & ofBlock = lineOfBlock[this->BlockIndex(x / BlockSize, y / BlockSize, blockZ)];
          const auto     line = m_Lines[(static_cast<std::size_t>(z) * m_Size[1] + y) * m_Size[0] + x];
          ofBlock = isFirst || ofBlock == line ? line : several;
        }
      }
    }
  });
  const auto isUniform = [&](int x, int y, int z) {
    const std::uint8_t line = lineOfBlock[this->BlockIndex(x, y, z)];
    for (int k = std::max(z - 1, 0); k <= std::min(z + 1, m_Blocks[2] - 1); ++k)
    {
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, m_Blocks[1] - 1); ++j)
      {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, m_Blocks[0] - 1); ++i)
        {
          if (lineOfBlock[this->BlockIndex(i, j, k)] != line)
          {
            return false;
          }
        }
      }
    }
    return line != several;
  };
  ForEach(m_Blocks[2], [&](int z) {
    for (int y = 0; y < m_Blocks[1]; ++y)
    {
      for (int x = 0; x < m_Blocks[0]; ++x)
      {
        Content & content = m_Content[this->BlockIndex(x, y, z)];
        if (content == Content::Mixed && isUniform(x, y, z))
        {
          content = Content::Uniform;
        }
      }
    }
  });
}

void
ClassifiedVolume::SmoothOpacity()
{
  const std::size_t slice = static_cast<std::size_t>(m_Size[0]) * m_Size[1];
  for (int pass = 0; pass < 3; ++pass)
  {
    ForEach(m_Size[2], [&](int z) {
      for (int y = 0; y < m_Size[1]; ++y)
      {
        SmoothLine(&m_SmoothOpacity[z * slice + static_cast<std::size_t>(y) * m_Size[0]], m_Size[0], 1);
      }
      for (int x = 0; x < m_Size[0]; ++x)
      {
        SmoothLine(&m_SmoothOpacity[z * slice + x], m_Size[1], m_Size[0]);
      }
    });
    ForEach(m_Size[1], [&](int y) {
      for (int x = 0; x < m_Size[0]; ++x)
      {
        SmoothLine(&m_SmoothOpacity[static_cast<std::size_t>(y) * m_Size[0] + x], m_Size[2], slice);
      }
    });
  }
}

ClassifiedVolume::Content
ClassifiedVolume::ContentAt(const double position[3]) const
{
  int block[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double within = std::min(std::max(position[axis], 0.0), m_Size[axis] - 1.0);
    block[axis] = static_cast<int>(within) / BlockSize;
  }
  return m_Content[this->BlockIndex(block[0], block[1], block[2])];
}

ClassifiedVolume::Sample
ClassifiedVolume::UniformSampleAt(const double position[3]) const
{
  int index[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    index[axis] = static_cast<int>(std::min(std::max(position[axis], 0.0), m_Size[axis] - 1.0));
  }
  return m_Samples[m_Lines[(static_cast<std::size_t>(index[2]) * m_Size[1] + index[1]) * m_Size[0] + index[0]]];
}

ClassifiedVolume::Sample
ClassifiedVolume::SampleAt(const double position[3]) const
{
  const Neighbours x = NeighboursOf(position[0], m_Size[0]);
  const Neighbours y = NeighboursOf(position[1], m_Size[1]);
  const Neighbours z = NeighboursOf(position[2], m_Size[2]);
  Sample           sum{};
  float            covered = 0.0F;
  const auto       add = [&](int i, int j, int k, float weight) {
    const std::uint8_t line = m_Lines[(static_cast<std::size_t>(k) * m_Size[1] + j) * m_Size[0] + i];
    if (m_Samples[line][3] > 0.0F)
    {
      covered += weight;
      for (std::size_t channel = 0; channel < sum.size(); ++channel)
      {
        sum[channel] += weight * m_Samples[line][channel];
      }
    }
  };
  const auto addRow = [&](int j, int k, float weight) {
    add(x.first, j, k, weight * (1.0F - x.share));
    add(x.second, j, k, weight * x.share);
  };
  addRow(y.first, z.first, (1.0F - y.share) * (1.0F - z.share));
  addRow(y.second, z.first, y.share * (1.0F - z.share));
  addRow(y.first, z.second, (1.0F - y.share) * z.share);
  addRow(y.second, z.second, y.share * z.share);
  const float factor = covered > 0.0F ? std::min(std::max(2.0F * covered - 0.5F, 0.0F), 1.0F) / covered : 0.0F;
  for (float & channel : sum)
  {
    channel *= factor;
  }
  return sum;
}

float
ClassifiedVolume::SmoothOpacityAt(int x, int y, int z) const
{
  return m_SmoothOpacity[(static_cast<std::size_t>(z) * m_Size[1] + y) * m_Size[0] + x] / fullOpacity;
}

std::array<float, 3>
ClassifiedVolume::GradientAt(const double position[3]) const
{
  const std::array<Neighbours, 3> near{
    { NeighboursOf(position[0], m_Size[0]), NeighboursOf(position[1], m_Size[1]), NeighboursOf(position[2], m_Size[2]) }
  };
  std::array<float, 3> gradient{};
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    int   index[3];
    float weight = 1.0F;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const bool isSecond = (corner >> axis) & 1U;
      index[axis] = isSecond ? near[axis].second : near[axis].first;
      weight *= isSecond ? near[axis].share : 1.0F - near[axis].share;
    }
    if (weight == 0.0F)
    {
      continue;
    }
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      int before[3] = { index[0], index[1], index[2] };
      int after[3] = { index[0], index[1], index[2] };
      before[axis] = std::max(index[axis] - 1, 0);
      after[axis] = std::min(index[axis] + 1, m_Size[axis] - 1);
      const float rise =
        this->SmoothOpacityAt(after[0], after[1], after[2]) - this->SmoothOpacityAt(before[0], before[1], before[2]);
      gradient[axis] += 0.5F * weight * rise;
    }
  }
  return gradient;
}
} // namespace shapeton
