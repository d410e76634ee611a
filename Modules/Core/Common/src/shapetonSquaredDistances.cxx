#include "shapetonSquaredDistances.h"

#include "shapetonParallelFor.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace shapeton
{
namespace
{
constexpr float unknown = UnknownSquaredDistance;

/** The lower envelope of the parabolas f(k) + (s (i - k))^2 over one line, with f = 0 outside the mask. */
class LineEnvelope
{
public:
  LineEnvelope(std::size_t size, double spacing, float greatest)
    : m_Squared(spacing * spacing), m_Greatest(greatest), m_Line(size), m_Vertex(size), m_From(size + 1)
  {}

  std::vector<float> &
  Line()
  {
    return m_Line;
  }

  /** Parabolas beyond a voxel outside the mask are never below the parabola of that voxel, so runs between such voxels
   * are independent. */
  void
  Transform()
  {
    const std::size_t size = m_Line.size();
    for (std::size_t i = 0; i < size;)
    {
      if (m_Line[i] == 0.0F)
      {
        ++i;
        continue;
      }
      std::size_t end = i;
      while (end < size && m_Line[end] != 0.0F)
      {
        ++end;
      }
      this->TransformRun(i == 0 ? 0 : i - 1, std::min(end, size - 1));
      i = end;
    }
  }

private:
  void
  TransformRun(std::size_t first, std::size_t last)
  {
    int top = -1;
    for (std::size_t k = first; k <= last; ++k)
    {
      if (m_Line[k] < unknown)
      {
        top = this->Push(top, k);
      }
    }
    if (top < 0)
    {
      return;
    }
    m_Values.resize(last - first + 1);
    int at = 0;
    for (std::size_t i = first; i <= last; ++i)
    {
      while (at < top && m_From[at + 1] < static_cast<double>(i))
      {
        ++at;
      }
      const double step = static_cast<double>(i) - static_cast<double>(m_Vertex[at]);
      const auto   value = static_cast<float>(m_Line[m_Vertex[at]] + m_Squared * step * step);
      m_Values[i - first] = value <= m_Greatest ? value : unknown;
    }
    std::copy(m_Values.begin(), m_Values.end(), m_Line.begin() + first);
  }

  int
  Push(int top, std::size_t k)
  {
    const double q = static_cast<double>(k);
    double       from = -std::numeric_limits<double>::infinity();
    while (top >= 0)
    {
      const double v = static_cast<double>(m_Vertex[top]);
      from = 0.5 * ((m_Line[k] - m_Line[m_Vertex[top]]) / (m_Squared * (q - v)) + q + v);
      if (from > m_From[top])
      {
        break;
      }
      --top;
    }
    ++top;
    m_Vertex[top] = k;
    m_From[top] = top == 0 ? -std::numeric_limits<double>::infinity() : from;
    return top;
  }

  double                   m_Squared;
  float                    m_Greatest;
  std::vector<float>       m_Line;
  std::vector<std::size_t> m_Vertex;
  std::vector<double>      m_From;
  std::vector<float>       m_Values;
};

/** Squared distances along x in one row, clamped to the maximum. */
void
TransformRow(const unsigned char * lumen, float * squared, std::size_t size, double spacing, float greatest)
{
  float steps = unknown;
  for (std::size_t i = 0; i < size; ++i)
  {
    steps = lumen[i] == 0 ? 0.0F : (steps < unknown ? steps + 1.0F : unknown);
    squared[i] = steps;
  }
  steps = unknown;
  for (std::size_t i = size; i-- > 0;)
  {
    steps = lumen[i] == 0 ? 0.0F : (steps < unknown ? steps + 1.0F : unknown);
    const double nearest = std::min(squared[i], steps);
    const auto   value = static_cast<float>(nearest * nearest * spacing * spacing);
    squared[i] = nearest < unknown && value <= greatest ? value : unknown;
  }
}

/** Processes all lines of one plane across the rows, several rows at once to use full cache lines. */
void
TransformPlane(float * plane, std::size_t width, std::size_t lines, std::size_t stride, double spacing, float greatest)
{
  constexpr std::size_t     block = 16;
  std::vector<LineEnvelope> envelopes(std::min(block, width), LineEnvelope(lines, spacing, greatest));
  for (std::size_t x = 0; x < width; x += block)
  {
    const std::size_t number = std::min(block, width - x);
    float             lowest = unknown;
    float             highest = 0.0F;
    for (std::size_t k = 0; k < lines; ++k)
    {
      for (std::size_t b = 0; b < number; ++b)
      {
        const float value = plane[k * stride + x + b];
        envelopes[b].Line()[k] = value;
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
      }
    }
    if (lowest == unknown || highest == 0.0F)
    {
      continue;
    }
    for (std::size_t b = 0; b < number; ++b)
    {
      envelopes[b].Transform();
    }
    for (std::size_t k = 0; k < lines; ++k)
    {
      for (std::size_t b = 0; b < number; ++b)
      {
        plane[k * stride + x + b] = envelopes[b].Line()[k];
      }
    }
  }
}
} // namespace

void
SquaredDistances(const VoxelRows &             mask,
                 const VoxelGrid &             box,
                 const std::array<double, 3> & spacing,
                 float *                       squares,
                 double                        farthest)
{
  const std::size_t row = box.stride[1];
  const std::size_t slice = box.stride[2];
  const auto        greatest = static_cast<float>(std::min<double>(farthest * farthest, unknown));
  ParallelFor(box.size[2], [&](std::size_t z) {
    for (int y = 0; y < box.size[1]; ++y)
    {
      TransformRow(mask.first + y * mask.rowStride + z * mask.sliceStride,
                   squares + z * slice + y * row,
                   row,
                   spacing[0],
                   greatest);
    }
    TransformPlane(squares + z * slice, row, box.size[1], row, spacing[1], greatest);
  });
  ParallelFor(box.size[1],
              [&](std::size_t y) { TransformPlane(squares + y * row, row, box.size[2], slice, spacing[2], greatest); });
}

VoxelValues
SquaredDistances(const VoxelGrid &                  grid,
                 const std::array<double, 3> &      spacing,
                 const std::vector<unsigned char> & mask,
                 double                             farthest)
{
  VoxelValues squares(mask.size());
  SquaredDistances({ mask.data(), grid.stride[1], grid.stride[2] }, grid, spacing, squares.data(), farthest);
  return squares;
}
} // namespace shapeton
