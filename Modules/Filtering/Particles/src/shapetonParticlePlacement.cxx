#include "shapetonParticlePlacement.h"
#include "shapetonExceptions.h"

#include "shapetonParallelFor.h"
#include "shapetonPhilox.h"
#include "shapetonPlaceInVoxel.h"

#include <algorithm>
#include <array>
#include <vector>

namespace shapeton
{
namespace
{
/** Counters of placement differ from those of the steps, which count from 1. */
PhiloxWords<std::uint32_t>
PlacementWords(std::uint64_t seed, std::uint32_t shapeton, std::uint32_t block)
{
  return Philox4x32(seed, { shapeton, 0, 0, block });
}

void
Place(const ParticleKernels::Surroundings & surroundings,
      const ParticleKernels::Shapetons &    shapetons,
      std::size_t                           i,
      const std::array<std::uint32_t, 3> &  index,
      const std::array<float, 3> &          within)
{
  float * const places[3] = { shapetons.x + i, shapetons.y + i, shapetons.z + i };
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    *places[axis] = PlaceInVoxel(index[axis], within[axis]);
  }
  shapetons.voxel[i] = (index[2] * surroundings.size[1] + index[1]) * surroundings.size[0] + index[0];
}

/** Integers proportional to the density of the shapetons, summed by rows. */
class RowDensities
{
public:
  RowDensities(const ParticleKernels::Surroundings & surroundings,
               const ParticleRecords &               records,
               bool                                  byInitialHeat,
               const unsigned char *                 mask)
    : m_RowLength(surroundings.size[0])
    , m_Rows(surroundings.size[1])
    , m_Records(records)
    , m_ByInitialHeat(byInitialHeat)
    , m_Mask(mask)
    , m_Below(static_cast<std::size_t>(surroundings.size[1]) * surroundings.size[2] + 1, 0)
  {
    ParallelFor(surroundings.size[2], [this](std::size_t z) {
      for (std::size_t row = z * m_Rows; row < (z + 1) * m_Rows; ++row)
      {
        for (std::size_t voxel = row * m_RowLength; voxel < (row + 1) * m_RowLength; ++voxel)
        {
          m_Below[row + 1] += this->At(voxel);
        }
      }
    });
    for (std::size_t row = 1; row < m_Below.size(); ++row)
    {
      m_Below[row] += m_Below[row - 1];
    }
  }

  std::uint64_t
  GetWhole() const
  {
    return m_Below.back();
  }

  /** The voxel at which the cumulative density first exceeds `wanted`, which is less than the total. */
  std::array<std::uint32_t, 3>
  Find(std::uint64_t wanted) const
  {
    const std::size_t row = std::upper_bound(m_Below.begin(), m_Below.end(), wanted) - m_Below.begin() - 1;
    std::uint64_t     below = m_Below[row];
    std::size_t       x = 0;
    while ((below += this->At(row * m_RowLength + x)) <= wanted)
    {
      ++x;
    }
    return { static_cast<std::uint32_t>(x),
             static_cast<std::uint32_t>(row % m_Rows),
             static_cast<std::uint32_t>(row / m_Rows) };
  }

private:
  std::uint32_t
  At(std::size_t voxel) const
  {
    return m_Mask && m_Mask[voxel] == 0 ? 0 : m_ByInitialHeat ? m_Records.GetInitialHeat(voxel) : 1;
  }

  std::size_t                m_RowLength;
  std::size_t                m_Rows;
  const ParticleRecords &    m_Records;
  bool                       m_ByInitialHeat;
  const unsigned char *      m_Mask;
  std::vector<std::uint64_t> m_Below;
};
} // namespace

void
PlaceUniformly(const ParticleKernels::Surroundings & surroundings,
               const ParticleKernels::Shapetons &    shapetons,
               std::uint64_t                         seed)
{
  for (std::size_t i = 0; i < shapetons.number; ++i)
  {
    const auto                   words = PlacementWords(seed, static_cast<std::uint32_t>(i), 0);
    const std::uint32_t          random[3] = { words.a, words.b, words.c };
    std::array<std::uint32_t, 3> index{};
    std::array<float, 3>         within{};
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const std::uint64_t place = std::uint64_t{ random[axis] } * static_cast<std::uint32_t>(surroundings.size[axis]);
      index[axis] = static_cast<std::uint32_t>(place >> 32);
      within[axis] = UnitFloat(static_cast<std::uint32_t>(place));
    }
    Place(surroundings, shapetons, i, index, within);
  }
}

void
PlaceByDensity(const ParticleKernels::Surroundings & surroundings,
               const ParticleKernels::Shapetons &    shapetons,
               std::uint64_t                         seed,
               const ParticleRecords &               records,
               bool                                  byInitialHeat,
               const unsigned char *                 mask)
{
  const RowDensities  rows(surroundings, records, byInitialHeat, mask);
  const std::uint64_t whole = rows.GetWhole();
  if (whole == 0)
  {
    throw InputError(byInitialHeat
                       ? "no voxel (of the mask, if given) has initial heat, because it has no edges; use another "
                         "mask, or place the shapetons uniformly"
                       : "the mask is empty; shapetons require nonzero mask voxels");
  }
  for (std::size_t i = 0; i < shapetons.number; ++i)
  {
    const auto          words = PlacementWords(seed, static_cast<std::uint32_t>(i), 1);
    const auto          within = PlacementWords(seed, static_cast<std::uint32_t>(i), 2);
    const std::uint64_t random = std::uint64_t{ words.a } << 32 | words.b;
    Place(surroundings,
          shapetons,
          i,
          rows.Find(static_cast<std::uint64_t>((static_cast<unsigned __int128>(random) * whole) >> 64)),
          { UnitFloat(within.a), UnitFloat(within.b), UnitFloat(within.c) });
  }
}
} // namespace shapeton
