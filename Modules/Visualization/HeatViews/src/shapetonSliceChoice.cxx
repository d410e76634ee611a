#include "shapetonSliceChoice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace shapeton
{
namespace
{
constexpr double greatestSample = 4e6; // voxels

/** Voxels of one part in each slice of each axis. */
using PartSections = std::array<std::vector<std::uint32_t>, 3>;

/** Sections of the parts, from every n-th voxel of each axis. partAt: the part of a voxel, from 1; 0 for none. */
template <typename TFunction>
std::vector<PartSections>
SectionsOf(const itk::ImageBase<3> * image, const TFunction & partAt)
{
  const auto                region = image->GetBufferedRegion();
  const auto                size = region.GetSize();
  const double              voxels = static_cast<double>(region.GetNumberOfPixels());
  const auto                stride = std::max<std::size_t>(std::lround(std::cbrt(voxels / greatestSample)), 1);
  std::vector<PartSections> parts;
  for (std::size_t z = stride / 2; z < size[2]; z += stride)
  {
    for (std::size_t y = stride / 2; y < size[1]; y += stride)
    {
      for (std::size_t x = stride / 2; x < size[0]; x += stride)
      {
        const std::size_t part = partAt((z * size[1] + y) * size[0] + x);
        if (part == 0)
        {
          continue;
        }
        while (parts.size() < part)
        {
          parts.push_back({ std::vector<std::uint32_t>(size[0]),
                            std::vector<std::uint32_t>(size[1]),
                            std::vector<std::uint32_t>(size[2]) });
        }
        PartSections & sections = parts[part - 1];
        ++sections[0][x];
        ++sections[1][y];
        ++sections[2][z];
      }
    }
  }
  return parts;
}

/** Index of the best slice along an axis of `size` slices. */
std::size_t
BestSlice(const std::vector<PartSections> & parts, unsigned int axis, std::size_t size)
{
  std::vector<double> scores(size, 0.0);
  for (const PartSections & part : parts)
  {
    const auto & sections = part[axis];
    const double voxels = std::accumulate(sections.begin(), sections.end(), 0.0);
    const double greatest = std::max(1U, *std::max_element(sections.begin(), sections.end()));
    for (std::size_t slice = 0; slice < size; ++slice)
    {
      scores[slice] += std::cbrt(voxels) * std::sqrt(sections[slice] / greatest);
    }
  }
  const auto rank = [&](std::size_t slice) {
    return std::make_pair(scores[slice], -std::fabs(static_cast<double>(slice) - 0.5 * (size - 1.0)));
  };
  std::size_t best = 0;
  for (std::size_t slice = 1; slice < size; ++slice)
  {
    best = rank(slice) > rank(best) ? slice : best;
  }
  return best;
}

template <typename TFunction>
itk::Index<3>
Cut(const itk::ImageBase<3> * image, const TFunction & partAt)
{
  const auto    region = image->GetBufferedRegion();
  const auto    parts = SectionsOf(image, partAt);
  itk::Index<3> cut = region.GetIndex();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    cut[axis] += static_cast<itk::IndexValueType>(BestSlice(parts, axis, region.GetSize(axis)));
  }
  return cut;
}
} // namespace

itk::Index<3>
CutThroughParts(const itk::Image<float, 3> * values, const ShapeTransferFunction & lines)
{
  return Cut(values, [&](std::size_t voxel) -> std::size_t {
    const int line = lines.LineOf(values->GetBufferPointer()[voxel]);
    return line >= 0 && lines.GetLines()[line].opacity > 0.0 ? line + 1 : 0;
  });
}

itk::Index<3>
CutThroughParts(const HeatObjectList::LabelImage * labels)
{
  return Cut(labels, [&](std::size_t voxel) -> std::size_t { return labels->GetBufferPointer()[voxel]; });
}
} // namespace shapeton
