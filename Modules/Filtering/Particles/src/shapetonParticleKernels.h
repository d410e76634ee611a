#ifndef shapetonParticleKernels_h
#define shapetonParticleKernels_h

#include "shapetonInstructionSets.h"
#include "shapetonParticleDirection.h"

#include <cstddef>
#include <cstdint>

namespace shapeton
{
/** Shapeton arithmetic, vectorized over shapetons, for each instruction set: see InstructionSets. */
namespace ParticleKernels
{
/** Length of a voxel's record: the weights of the edges at -x, +x, -y, +y, -z, +z in units of 1 / 65535, and marks. */
constexpr unsigned int  RecordLength = 8;
constexpr unsigned int  MarksOfRecord = 6;
constexpr std::uint16_t ObjectMark = 1; ///< the voxel is counted for the coverage
constexpr std::uint16_t TrapMark = 2;   ///< all six weights are 0

/** Volume data used by the shapetons. */
struct Surroundings
{
  const std::uint16_t * records;
  const std::uint32_t * visits; ///< prefetched
  std::int32_t          size[3];
  float                 step[3]; ///< length of a step along each axis, in voxels
};

/** Shapetons first, first + 1, ..., their positions in voxels (a voxel covers the interval from its index to the
 * next one) and the indices of their voxels. Arrays are accessed in whole vectors: see Granularity. */
struct Shapetons
{
  std::uint32_t   first;
  std::size_t     number;
  float *         x;
  float *         y;
  float *         z;
  std::uint32_t * voxel;
};

/** Components of unit vectors. */
struct Directions
{
  float * x;
  float * y;
  float * z;
};

/** Array lengths are multiples of this. */
constexpr std::size_t Granularity = 16;

/** Entries of the tables of ThetaTable. */
constexpr int ThetaTableSize = 512;

/** 1 - cos(theta) and cos(theta) by quantile, for theta distributed as (1 - u)^(3-j) u^j sin(theta): with a quantile
 * q below one half, `low[j]` is 1 - cos(theta) at q = (i / ThetaTableSize)^2 / 2; above it, `high[j]` is cos(theta) at
 * 1 - q = (i / ThetaTableSize)^2 / 2. Smooth in i, so that linear interpolation has an error of 1e-5. */
struct ThetaTable
{
  ThetaTable();
  float low[4][ThetaTableSize + 1];
  float high[4][ThetaTableSize + 1];
};

struct Random
{
  std::uint64_t seed;
  std::uint64_t step;
};

using Sampling = DirectionSampling;
constexpr std::size_t NumberOfSamplings = 4;

/** Samples directions from the weights of the shapetons' voxels; the zero vector if all weights are 0. */
using Draw = void (*)(const Surroundings &, const Shapetons &, const Random &, const ThetaTable &, const Directions &);

/** Moves shapetons by one step, reflected at the border of the volume, and finds their voxels. */
using Move = void (*)(const Surroundings &, const Shapetons &, const Directions &);

struct Set
{
  const char * name;
  Draw         draw[NumberOfSamplings];
  Move         move;

  Draw
  DrawOf(Sampling sampling) const
  {
    return draw[static_cast<std::size_t>(sampling)];
  }

  static const Set & Compiled(InstructionSets::Baseline);
  static const Set & Compiled(InstructionSets::Avx2);
  static const Set & Compiled(InstructionSets::Avx512);
};
} // namespace ParticleKernels
} // namespace shapeton

#endif
