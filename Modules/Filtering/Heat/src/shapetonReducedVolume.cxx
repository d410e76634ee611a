#include "shapetonReducedVolume.h"

#include "shapetonExceptions.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using Size = std::array<std::size_t, 3>;
using Spacing = std::array<double, 3>;

/** Largest copy, 128^3. Six diffusions on it cost about half as much as a run on 256^3. */
constexpr std::size_t GreatestCopy = 128 * 128 * 128;
/** Sides of the copy are not reduced below this many voxels. */
constexpr std::size_t LeastSide = 16;

/** Voxels per block along each axis for voxels of `side` mm. */
Size
Blocks(const Size & size, const Spacing & spacing, double side)
{
  Size blocks{};
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const auto wanted = static_cast<std::size_t>(std::max(1L, std::lround(side / spacing[axis])));
    blocks[axis] = std::clamp<std::size_t>(wanted, 1, std::max<std::size_t>(1, size[axis] / LeastSide));
  }
  return blocks;
}

constexpr unsigned char Part = 1, Most = 2; // of a block in the domain

/** The blocks of which most voxels are in the domain; if there are none, those with any voxel in it. */
std::vector<unsigned char>
DomainOf(std::vector<unsigned char> blocks)
{
  const unsigned char greatest = *std::max_element(blocks.begin(), blocks.end());
  if (greatest == 0)
  {
    throw InputError("the domain of the volume has no voxel, or too few to choose parameters; use a larger mask");
  }
  std::transform(
    blocks.begin(), blocks.end(), blocks.begin(), [greatest](unsigned char block) { return block == greatest; });
  return blocks;
}

ReducedVolume
Average(const VolumeView & volume, const Size & blocks)
{
  Size    size{};
  Spacing spacing{};
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    size[axis] = volume.size[axis] / blocks[axis];
    spacing[axis] = volume.spacing[axis] * static_cast<double>(blocks[axis]);
  }
  std::vector<float>         values(size[0] * size[1] * size[2]);
  std::vector<unsigned char> domain(volume.domain ? values.size() : 0);
  const std::size_t          voxels = blocks[0] * blocks[1] * blocks[2];
  ParallelFor(size[2], [&](std::size_t z) {
    std::vector<double>      sums(size[0]);
    std::vector<std::size_t> counts(size[0]);
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      std::fill(sums.begin(), sums.end(), 0.0);
      std::fill(counts.begin(), counts.end(), volume.domain ? 0 : voxels);
      for (std::size_t row = 0; row < blocks[1] * blocks[2]; ++row)
      {
        const std::size_t inY = y * blocks[1] + row % blocks[1];
        const std::size_t inZ = z * blocks[2] + row / blocks[1];
        const std::size_t first = (inZ * volume.size[1] + inY) * volume.size[0];
        for (std::size_t x = 0; x < size[0] * blocks[0]; ++x)
        {
          const bool isIn = volume.IsInDomain(first + x);
          sums[x / blocks[0]] += isIn ? volume.values[first + x] : 0.0;
          counts[x / blocks[0]] += volume.domain && isIn ? 1 : 0;
        }
      }
      const std::size_t row = (z * size[1] + y) * size[0];
      for (std::size_t x = 0; x < size[0]; ++x)
      {
        values[row + x] = static_cast<float>(sums[x] / static_cast<double>(std::max<std::size_t>(1, counts[x])));
        if (volume.domain)
        {
          domain[row + x] = 2 * counts[x] >= voxels ? Most : counts[x] > 0 ? Part : 0;
        }
      }
    }
  });
  ReducedVolume reduced{ VolumeView(std::move(values), size, spacing),
                         SmallestSpacing(spacing) / SmallestSpacing(volume.spacing) };
  reduced.domain =
    volume.domain ? std::make_shared<const std::vector<unsigned char>>(DomainOf(std::move(domain))) : nullptr;
  return reduced;
}
} // namespace

double
SmallestSpacing(const Spacing & spacing)
{
  return std::min({ spacing[0], spacing[1], spacing[2] });
}

ReducedVolume
ReduceVolume(const VolumeView & volume)
{
  const Size & size = volume.size;
  Size         blocks{};
  for (double side = 2.0;; side += 1.0)
  {
    const Size next = Blocks(size, volume.spacing, side * SmallestSpacing(volume.spacing));
    const bool same = next == blocks;
    blocks = next;
    const std::size_t voxels = (size[0] / blocks[0]) * (size[1] / blocks[1]) * (size[2] / blocks[2]);
    if (voxels <= GreatestCopy || (same && side > static_cast<double>(*std::max_element(size.begin(), size.end()))))
    {
      return Average(volume, blocks);
    }
  }
}
} // namespace shapeton
