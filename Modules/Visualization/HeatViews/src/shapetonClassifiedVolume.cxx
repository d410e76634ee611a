#include "shapetonClassifiedVolume.h"

#include "shapetonParallelFor.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** Filters a line of values in place with the binomial kernel 1 2 1; the ends are repeated. */
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
  m_Samples.push_back(RaySample{});
  for (const TransferFunctionLine & line : transferFunction.GetLines())
  {
    const auto opacity = static_cast<float>(line.opacity);
    m_Samples.push_back({ { opacity * static_cast<float>(line.color[0]) / 255.0F,
                            opacity * static_cast<float>(line.color[1]) / 255.0F,
                            opacity * static_cast<float>(line.color[2]) / 255.0F,
                            opacity } });
  }
  const std::size_t   slice = static_cast<std::size_t>(m_Size[0]) * m_Size[1];
  const float * const heats = heat->GetBufferPointer();
  m_Lines.resize(slice * m_Size[2]);
  m_SmoothOpacity.resize(m_Lines.size());
  ParallelFor(m_Size[2], [&](int z) {
    for (std::size_t i = z * slice; i < (z + 1) * slice; ++i)
    {
      m_Lines[i] = static_cast<std::uint8_t>(transferFunction.LineOf(heats[i]) + 1);
      m_SmoothOpacity[i] = static_cast<std::uint16_t>(m_Samples[m_Lines[i]].channel[3] * FullOpacity + 0.5F);
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
  // A block includes one voxel beyond its borders, for interpolation.
  ParallelFor(m_Blocks[2], [&](int blockZ) {
    const int firstZ = std::max(blockZ * BlockSize - 1, 0);
    const int endZ = std::min((blockZ + 1) * BlockSize + 1, m_Size[2]);
    for (int z = firstZ; z < endZ; ++z)
    {
      for (int y = 0; y < m_Size[1]; ++y)
      {
        for (int x = 0; x < m_Size[0]; ++x)
        {
          const std::uint8_t line = m_Lines[(static_cast<std::size_t>(z) * m_Size[1] + y) * m_Size[0] + x];
          if (m_Samples[line].channel[3] == 0.0F)
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
  // A block and all its neighbors cover the support of opacity smoothing and of the gradient's differences.
  constexpr std::uint8_t    several = 255;
  std::vector<std::uint8_t> lineOfBlock(m_Content.size());
  ParallelFor(m_Blocks[2], [&](int blockZ) {
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
  ParallelFor(m_Blocks[2], [&](int z) {
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
    ParallelFor(m_Size[2], [&](int z) {
      for (int y = 0; y < m_Size[1]; ++y)
      {
        SmoothLine(&m_SmoothOpacity[z * slice + static_cast<std::size_t>(y) * m_Size[0]], m_Size[0], 1);
      }
      for (int x = 0; x < m_Size[0]; ++x)
      {
        SmoothLine(&m_SmoothOpacity[z * slice + x], m_Size[1], m_Size[0]);
      }
    });
    ParallelFor(m_Size[1], [&](int y) {
      for (int x = 0; x < m_Size[0]; ++x)
      {
        SmoothLine(&m_SmoothOpacity[static_cast<std::size_t>(y) * m_Size[0] + x], m_Size[2], slice);
      }
    });
  }
}

RayVolume
ClassifiedVolume::GetRayVolume() const
{
  return { { m_Size[0], m_Size[1], m_Size[2] },
           { m_Blocks[0], m_Blocks[1], m_Blocks[2] },
           m_Samples.data(),
           m_Lines.data(),
           m_SmoothOpacity.data(),
           m_Content.data() };
}
} // namespace shapeton
