#ifndef shapetonParticleKernelsTestTools_h
#define shapetonParticleKernelsTestTools_h

#include "shapetonParticleKernels.h"

#include <array>
#include <cstring>
#include <random>
#include <vector>

namespace shapeton
{
namespace test
{
inline const ParticleKernels::ThetaTable &
Table()
{
  static const ParticleKernels::ThetaTable table;
  return table;
}

/** A few shapetons and their volume, in the array layout of the kernels. */
struct Crowd
{
  Crowd(std::size_t numberOfShapetons, const std::array<std::int32_t, 3> & size)
    : number(numberOfShapetons)
    , records(static_cast<std::size_t>(size[0]) * size[1] * size[2] * ParticleKernels::RecordLength, 0)
    , visits(static_cast<std::size_t>(size[0]) * size[1] * size[2], 0)
    , voxels(PaddedNumber(), 0)
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      places[axis].assign(PaddedNumber(), 0.0F);
      directions[axis].assign(PaddedNumber(), 0.0F);
      surroundings.size[axis] = size[axis];
    }
  }

  std::size_t
  PaddedNumber() const
  {
    constexpr std::size_t granularity = ParticleKernels::Granularity;
    return (number + granularity - 1) / granularity * granularity;
  }

  void
  SetWeights(std::size_t voxel, const std::array<std::uint16_t, 6> & weights)
  {
    std::uint16_t * const record = records.data() + voxel * ParticleKernels::RecordLength;
    std::copy(weights.begin(), weights.end(), record);
    const bool trap = weights == std::array<std::uint16_t, 6>{};
    record[ParticleKernels::MarksOfRecord] = trap ? ParticleKernels::TrapMark : 0;
  }

  ParticleKernels::Surroundings
  GetSurroundings() const
  {
    ParticleKernels::Surroundings own = surroundings;
    own.records = records.data();
    own.visits = visits.data();
    return own;
  }

  ParticleKernels::Shapetons
  GetShapetons(std::uint32_t first = 0)
  {
    return { first, number, places[0].data(), places[1].data(), places[2].data(), voxels.data() };
  }

  ParticleKernels::Directions
  GetDirections()
  {
    return { directions[0].data(), directions[1].data(), directions[2].data() };
  }

  std::size_t                       number;
  std::vector<std::uint16_t>        records;
  std::vector<std::uint32_t>        visits;
  std::array<std::vector<float>, 3> places;
  std::array<std::vector<float>, 3> directions;
  std::vector<std::uint32_t>        voxels;
  ParticleKernels::Surroundings     surroundings{};
};

template <typename TNumber>
bool
SameBytes(const std::vector<TNumber> & a, const std::vector<TNumber> & b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(TNumber)) == 0;
}
} // namespace test
} // namespace shapeton

#endif
