#include "itkLumenDistance.h"

#include "itkParallelFor.h"
#include "itkToolError.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace itk
{
namespace
{
/** No voxel outside the lumen is known yet. Its square root is still finite. */
constexpr float unknown = 1e30F;

bool
HasLumen(const unsigned char * row, std::size_t size, std::size_t & first, std::size_t & last)
{
  first = 0;
  while (first < size && row[first] == 0)
  {
    ++first;
  }
  if (first == size)
  {
    return false;
  }
  last = size - 1;
  while (row[last] == 0)
  {
    --last;
  }
  return true;
}

/** The lower envelope of the parabolas f(k) + (s (i - k))^2 over one line, where f is 0 outside the lumen. */
class LineEnvelope
{
public:
  LineEnvelope(std::size_t size, double spacing)
    : m_Squared(spacing * spacing), m_Line(size), m_Vertex(size), m_From(size + 1)
  {}

  std::vector<float> &
  Line()
  {
    return m_Line;
  }

  /** Parabolas beyond a voxel outside the lumen are never below its own, so runs between such voxels are
   * independent. */
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
      m_Values[i - first] = static_cast<float>(m_Line[m_Vertex[at]] + m_Squared * step * step);
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
  std::vector<float>       m_Line;
  std::vector<std::size_t> m_Vertex;
  std::vector<double>      m_From;
  std::vector<float>       m_Values;
};

/** Squared distances along x of one row. */
void
TransformRow(const unsigned char * lumen, float * squared, std::size_t size, double spacing)
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
    squared[i] = nearest < unknown ? static_cast<float>(nearest * nearest * spacing * spacing) : unknown;
  }
}

/** All lines of one plane that run across the rows; some rows side by side, since memory comes by cache lines. */
void
TransformPlane(float * plane, std::size_t width, std::size_t lines, std::size_t stride, double spacing)
{
  constexpr std::size_t     block = 16;
  std::vector<LineEnvelope> envelopes(std::min(block, width), LineEnvelope(lines, spacing));
  for (std::size_t x = 0; x < width; x += block)
  {
    const std::size_t number = std::min(block, width - x);
    float             highest = 0.0F;
    for (std::size_t k = 0; k < lines; ++k)
    {
      for (std::size_t b = 0; b < number; ++b)
      {
        const float value = plane[k * stride + x + b];
        envelopes[b].Line()[k] = value;
        highest = std::max(highest, value);
      }
    }
    if (highest == 0.0F)
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

template <typename TImage>
typename TImage::Pointer
ImageOfRegion(const LumenMask * lumen, const ImageRegion<3> & region)
{
  const auto image = TImage::New();
  image->SetRegions(region);
  image->SetSpacing(lumen->GetSpacing());
  image->SetOrigin(lumen->GetOrigin());
  image->SetDirection(lumen->GetDirection());
  image->Allocate();
  return image;
}
} // namespace

ImageRegion<3>
LumenRegion(const LumenMask * lumen, unsigned int margin)
{
  const ImageRegion<3>                    whole = lumen->GetBufferedRegion();
  const auto                              size = whole.GetSize();
  std::vector<std::array<std::size_t, 4>> extents(size[2], { size[0], 0, size[1], 0 });
  ParallelFor(size[2], [&](std::size_t z) {
    const unsigned char * const slice = lumen->GetBufferPointer() + z * size[0] * size[1];
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      std::size_t first = 0;
      std::size_t last = 0;
      if (HasLumen(slice + y * size[0], size[0], first, last))
      {
        auto & e = extents[z];
        e = { std::min(e[0], first), std::max(e[1], last), std::min(e[2], y), std::max(e[3], y) };
      }
    }
  });
  std::array<std::size_t, 6> box = { size[0], 0, size[1], 0, size[2], 0 };
  for (std::size_t z = 0; z < size[2]; ++z)
  {
    const auto & e = extents[z];
    if (e[0] < size[0])
    {
      box = { std::min(box[0], e[0]), std::max(box[1], e[1]), std::min(box[2], e[2]),
              std::max(box[3], e[3]), std::min(box[4], z),    std::max(box[5], z) };
    }
  }
  if (box[0] == size[0])
  {
    throw InputError("the lumen mask is empty: no voxel differs from 0. Give a mask whose lumen is not 0.");
  }
  ImageRegion<3> region = whole;
  for (unsigned int a = 0; a < 3; ++a)
  {
    region.SetIndex(a, whole.GetIndex(a) + static_cast<IndexValueType>(box[2 * a]));
    region.SetSize(a, box[2 * a + 1] - box[2 * a] + 1);
  }
  region.PadByRadius(margin);
  region.Crop(whole);
  return region;
}

LumenDistanceImage::Pointer
LumenDistance(const LumenMask * lumen, const ImageRegion<3> & region)
{
  const auto        image = ImageOfRegion<LumenDistanceImage>(lumen, region);
  const auto        size = region.GetSize();
  const auto        spacing = lumen->GetSpacing();
  const std::size_t row = size[0];
  const std::size_t slice = row * size[1];
  float * const     values = image->GetBufferPointer();
  ParallelFor(size[2], [&](std::size_t z) {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      const Index<3> first = { { region.GetIndex(0),
                                 region.GetIndex(1) + static_cast<IndexValueType>(y),
                                 region.GetIndex(2) + static_cast<IndexValueType>(z) } };
      TransformRow(
        lumen->GetBufferPointer() + lumen->ComputeOffset(first), values + z * slice + y * row, row, spacing[0]);
    }
    TransformPlane(values + z * slice, row, size[1], row, spacing[1]);
  });
  ParallelFor(size[1], [&](std::size_t y) { TransformPlane(values + y * row, row, size[2], slice, spacing[2]); });
  const double      toWall = 0.25 * std::min({ spacing[0], spacing[1], spacing[2] });
  std::vector<char> isUnknown(size[2], 0);
  ParallelFor(size[2], [&](std::size_t z) {
    for (float * value = values + z * slice; value != values + (z + 1) * slice; ++value)
    {
      isUnknown[z] = isUnknown[z] || *value >= unknown;
      *value = *value > 0.0F ? static_cast<float>(std::sqrt(static_cast<double>(*value)) - toWall) : 0.0F;
    }
  });
  if (std::find(isUnknown.begin(), isUnknown.end(), 1) != isUnknown.end())
  {
    throw InputError("the lumen mask fills its whole box: there is no wall. Give a mask whose background is 0.");
  }
  return image;
}
} // namespace itk
