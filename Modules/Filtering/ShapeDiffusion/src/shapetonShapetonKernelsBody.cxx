// Compiled once for each instruction set: see shapetonInstructionSets.h.
#include "shapetonPhilox.h"
#include "shapetonShapetonKernels.h"
#include "shapetonShapetonMoments.h"

#if defined(__x86_64__)
#  include <immintrin.h>
#endif

namespace shapeton
{
namespace ShapetonKernels
{
namespace
{
constexpr int lanes = SHAPETON_VECTOR_BYTES / 4;
using Floats = float __attribute__((vector_size(SHAPETON_VECTOR_BYTES)));
using Integers = std::int32_t __attribute__((vector_size(SHAPETON_VECTOR_BYTES)));
using Words = std::uint32_t __attribute__((vector_size(SHAPETON_VECTOR_BYTES)));

#define SHAPETON_INLINE __attribute__((always_inline)) inline

SHAPETON_INLINE Floats
Broadcast(float value)
{
  return value - Floats{};
}

SHAPETON_INLINE Floats
Maximum(Floats a, Floats b)
{
  return a > b ? a : b;
}

SHAPETON_INLINE Floats
Minimum(Floats a, Floats b)
{
  return a < b ? a : b;
}

SHAPETON_INLINE Floats
Magnitude(Floats a)
{
  return (Floats)((Integers)a & 0x7fffffff);
}

SHAPETON_INLINE Floats
SquareRoot(Floats a)
{
#if defined(__AVX512F__)
  return (Floats)_mm512_sqrt_ps((__m512)a);
#elif defined(__AVX2__)
  return (Floats)_mm256_sqrt_ps((__m256)a);
#elif defined(__SSE2__)
  return (Floats)_mm_sqrt_ps((__m128)a);
#else
  Floats root;
  for (int lane = 0; lane < lanes; ++lane)
  {
    root[lane] = __builtin_sqrtf(a[lane]);
  }
  return root;
#endif
}

/** Cube root of numbers that are not negative: an estimate from the exponent, and two steps of Halley's method. */
SHAPETON_INLINE Floats
CubeRoot(Floats a)
{
  const Integers third =
    __builtin_convertvector(__builtin_convertvector((Integers)a, Floats) * (1.0F / 3.0F), Integers);
  Floats root = (Floats)(third + 709921077);
  for (int iteration = 0; iteration < 2; ++iteration)
  {
    const Floats cube = root * root * root;
    root = root * (cube + 2.0F * a) / (2.0F * cube + a);
  }
  return a > 1e-30F ? root : Broadcast(0.0F);
}

/** sin(pi/2 u) for u in [0, 1]. */
SHAPETON_INLINE Floats
SineOfQuarter(Floats u)
{
  const Floats t = u * u;
  return u * (1.5707963F + t * (-0.64596409F +
                                t * (0.079692626F + t * (-0.0046817541F + t * (0.00016044118F + t * -3.5988432e-6F)))));
}

struct Multiply
{
  SHAPETON_INLINE void
  operator()(Words x, std::uint32_t factor, Words & high, Words & low) const
  {
    // Products of the even and of the odd elements, 64 bits each.
#if defined(__AVX512F__)
    const __m512i f = _mm512_set1_epi32(static_cast<int>(factor));
    const __m512i even = _mm512_mul_epu32((__m512i)x, f);
    const __m512i odd = _mm512_mul_epu32(_mm512_srli_epi64((__m512i)x, 32), f);
    low = (Words)_mm512_mask_blend_epi32(0xAAAA, even, _mm512_slli_epi64(odd, 32));
    high = (Words)_mm512_mask_blend_epi32(0xAAAA, _mm512_srli_epi64(even, 32), odd);
#elif defined(__AVX2__)
    const __m256i f = _mm256_set1_epi32(static_cast<int>(factor));
    const __m256i even = _mm256_mul_epu32((__m256i)x, f);
    const __m256i odd = _mm256_mul_epu32(_mm256_srli_epi64((__m256i)x, 32), f);
    low = (Words)_mm256_blend_epi32(even, _mm256_slli_epi64(odd, 32), 0xAA);
    high = (Words)_mm256_blend_epi32(_mm256_srli_epi64(even, 32), odd, 0xAA);
#elif defined(__SSE2__)
    const __m128i f = _mm_set1_epi32(static_cast<int>(factor));
    const __m128i lowHalf = _mm_set1_epi64x(0xffffffff);
    const __m128i even = _mm_mul_epu32((__m128i)x, f);
    const __m128i odd = _mm_mul_epu32(_mm_srli_epi64((__m128i)x, 32), f);
    low = (Words)_mm_or_si128(_mm_and_si128(even, lowHalf), _mm_slli_epi64(odd, 32));
    high = (Words)_mm_or_si128(_mm_srli_epi64(even, 32), _mm_andnot_si128(lowHalf, odd));
#else
    for (int lane = 0; lane < lanes; ++lane)
    {
      const std::uint64_t product = std::uint64_t{ x[lane] } * factor;
      high[lane] = static_cast<std::uint32_t>(product >> 32);
      low[lane] = static_cast<std::uint32_t>(product);
    }
#endif
  }
};

/** Numbers in (0, 1]. */
SHAPETON_INLINE Floats
ToUnit(Words words)
{
  return (__builtin_convertvector((Integers)(words >> 8), Floats) + 1.0F) * (1.0F / 16777216.0F);
}

/** The value where bit 0 of `bit` is set, else its negative. */
SHAPETON_INLINE Floats
WithSign(Floats value, Integers bit)
{
  return (Floats)((Integers)value ^ ((bit & 1) << 31 ^ static_cast<std::int32_t>(0x80000000U)));
}

template <typename TVector>
SHAPETON_INLINE TVector
Load(const void * memory)
{
  TVector vector;
  __builtin_memcpy(&vector, memory, sizeof(vector));
  return vector;
}

template <typename TVector>
SHAPETON_INLINE void
Store(void * memory, TVector vector)
{
  __builtin_memcpy(memory, &vector, sizeof(vector));
}

/** The six weights, in units of 1 / 65535: directions depend on their ratios alone. */
struct Weights
{
  Floats w[6];
};

SHAPETON_INLINE Weights
LoadWeights(const std::uint16_t * records, const std::uint32_t * voxels)
{
  Weights       weights;
  std::uint32_t pairs[3][lanes];
  for (int lane = 0; lane < lanes; ++lane)
  {
    const std::uint16_t * const record = records + static_cast<std::size_t>(voxels[lane]) * RecordLength;
    __builtin_memcpy(&pairs[0][lane], record, 4);
    __builtin_memcpy(&pairs[1][lane], record + 2, 4);
    __builtin_memcpy(&pairs[2][lane], record + 4, 4);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto pair = Load<Integers>(pairs[axis]);
    weights.w[2 * axis] = __builtin_convertvector(pair & 0xffff, Floats);
    weights.w[2 * axis + 1] = __builtin_convertvector((Integers)((Words)pair >> 16), Floats);
  }
  return weights;
}

/** Where all six weights are 0. */
SHAPETON_INLINE Integers
LoadTraps(const std::uint16_t * records, const std::uint32_t * voxels)
{
  Integers marks;
  for (int lane = 0; lane < lanes; ++lane)
  {
    marks[lane] = records[static_cast<std::size_t>(voxels[lane]) * RecordLength + MarksOfRecord];
  }
  return (marks & TrapMark) != 0;
}

constexpr float moment0 = static_cast<float>(ShapetonMoments::moment[0]);
constexpr float moment1 = static_cast<float>(ShapetonMoments::moment[1]);
constexpr float moment2 = static_cast<float>(ShapetonMoments::moment[2]);
constexpr float moment3 = static_cast<float>(ShapetonMoments::moment[3]);

/** The octant that was drawn and its three weights; bits 0, 1, 2 of `octant` say +x, +y, +z. */
struct Octant
{
  Integers octant;
  Floats   w1;
  Floats   w2;
  Floats   w3;
  Integers empty; ///< all weights are 0
};

/** By volume (8.6); `random` in (0, 1]. */
SHAPETON_INLINE Octant
DrawOctant(const Weights & weights, Floats random)
{
  const Floats * const w = weights.w;
  Floats               volumes[8];
  Floats               whole = {};
  for (int k = 0; k < 4; ++k)
  {
    const Floats a = w[2 + (k & 1)];
    const Floats b = w[4 + (k >> 1)];
    const Floats aa = a * a;
    const Floats bb = b * b;
    // Means over phi of W, W^2 and W^3.
    const Floats mean1 = (a + b) * (0.5F * moment1);
    const Floats mean2 = (aa + a * b + bb) * (moment2 / 3.0F);
    const Floats mean3 = (aa + bb) * (a + b) * (0.25F * moment3);
    for (int side = 0; side < 2; ++side)
    {
      const Floats c = w[side];
      volumes[2 * k + side] = mean3 + c * (mean2 + c * (mean1 + c * moment0));
      whole += volumes[2 * k + side];
    }
  }
  const Floats wanted = random * whole;
  Octant       drawn = { Integers{}, w[0], w[2], w[4], whole <= 0.0F };
  Floats       below = volumes[0];
  for (int k = 1; k < 8; ++k)
  {
    const Integers beyond = wanted > below;
    below += volumes[k];
    drawn.octant = beyond ? Integers{} + k : drawn.octant;
    drawn.w1 = beyond ? w[k & 1] : drawn.w1;
    drawn.w2 = beyond ? w[2 + (k >> 1 & 1)] : drawn.w2;
    drawn.w3 = beyond ? w[4 + (k >> 2)] : drawn.w3;
  }
  return drawn;
}

/** s = 2 phi / pi by partial volume (8.5): the zero of a quartic by three Newton steps from where it would be if the
 * weight of the first axis only shifted the others. Error of the distribution function 1e-6. */
SHAPETON_INLINE Floats
DrawPhi(Floats w1, Floats w2, Floats w3, Floats random)
{
  const Floats shift = 0.2789F * w1;
  const Floats e0 = w2 + shift;
  const Floats e1 = w3 + shift;
  const Floats e02 = e0 * e0;
  const Floats e12 = e1 * e1;
  const Floats e04 = e02 * e02;
  const Floats root = SquareRoot(SquareRoot(Maximum(Floats{}, e04 + random * (e12 * e12 - e04))));
  Floats       s = random * ((e1 + e0) * (e12 + e02)) / Maximum((root + e0) * (root * root + e02), Broadcast(1e-20F));

  const Floats b = w3 - w2;
  const Floats w11 = w1 * w1;
  const Floats w22 = w2 * w2;
  const Floats g0 = moment0 * w11 * w1 + moment1 * w11 * w2 + moment2 * w1 * w22 + moment3 * w22 * w2;
  const Floats g1 = b * (moment1 * w11 + 2.0F * moment2 * w1 * w2 + 3.0F * moment3 * w22);
  const Floats g2 = b * b * (moment2 * w1 + 3.0F * moment3 * w2);
  const Floats g3 = b * b * b * moment3;
  const Floats wanted = random * (g0 + g1 * 0.5F + g2 * (1.0F / 3.0F) + g3 * 0.25F);
  for (int iteration = 0; iteration < 3; ++iteration)
  {
    s = Minimum(s, Broadcast(1.0F));
    const Floats below = s * (g0 + s * (g1 * 0.5F + s * (g2 * (1.0F / 3.0F) + s * g3 * 0.25F)));
    const Floats slope = g0 + s * (g1 + s * (g2 + s * g3));
    s = Minimum(Broadcast(1.0F), Maximum(Floats{}, s - (below - wanted) / Maximum(slope, Broadcast(1e-20F))));
  }
  return s;
}

struct Angle
{
  Floats cosine;
  Floats sine;
};

/** theta with density R^3 sin(theta). The cube of R = w1 (1 - u) + W u has four terms, and theta given the term does
 * not depend on the weights: one random number draws the term, the other looks theta up. */
SHAPETON_INLINE Angle
DrawThetaBySolidAngle(Floats w1, Floats across, Floats random, Floats termRandom, const ThetaTable & table)
{
  const Floats term0 = moment0 * w1 * w1 * w1;
  const Floats term1 = term0 + moment1 * w1 * w1 * across;
  const Floats term2 = term1 + moment2 * w1 * across * across;
  const Floats term3 = term2 + moment3 * across * across * across;
  const Floats wanted = termRandom * term3;
  // Comparisons are -1 where true.
  const Integers term = -((wanted > term0) + (wanted > term1) + (wanted > term2));
  const Integers isHigh = random > 0.5F;
  const Floats   share = isHigh ? 1.0F - random : random;
  const Floats   place = SquareRoot(share * 2.0F) * static_cast<float>(ThetaTableSize);
  const Integers cell = __builtin_convertvector(Minimum(place, Broadcast(ThetaTableSize - 1.0F)), Integers);
  const Floats   within = place - __builtin_convertvector(cell, Floats);
  const Integers entry = (term - isHigh * 4) * (ThetaTableSize + 1) + cell;
  const float *  entries = &table.low[0][0];
  Floats         left;
  Floats         right;
  for (int lane = 0; lane < lanes; ++lane)
  {
    left[lane] = entries[entry[lane]];
    right[lane] = entries[entry[lane] + 1];
  }
  const Floats value = left + within * (right - left);
  const Floats rest = 1.0F - value;
  Angle        angle;
  angle.cosine = isHigh ? value : rest;
  angle.sine = SquareRoot(Maximum(Floats{}, isHigh ? rest * (1.0F + value) : value * (1.0F + rest)));
  return angle;
}

/** theta by sector area (8.7), as published. */
SHAPETON_INLINE Angle
DrawThetaBySectorArea(Floats w1, Floats across, Floats random)
{
  // Scaled by the larger weight, so that cubes neither overflow nor vanish.
  const Floats scale = 1.0F / Maximum(Maximum(w1, across), Broadcast(1e-20F));
  const Floats a = w1 * scale;
  const Floats b = across * scale;
  const Floats aaa = a * a * a;
  const Floats root = CubeRoot(Maximum(Floats{}, aaa + random * (b * b * b - aaa)));
  const Floats u = Minimum(
    Broadcast(1.0F), random * (b * b + b * a + a * a) / Maximum(root * root + root * a + a * a, Broadcast(1e-20F)));
  return { SineOfQuarter(1.0F - u), SineOfQuarter(u) };
}

enum class Sampling
{
  SolidAngle,
  SectorArea,
  Uniform
};

template <Sampling VSampling>
void
DrawAll(const Surroundings & surroundings,
        const Shapetons &    shapetons,
        const Random &       random,
        const ThetaTable &   table,
        const Directions &   directions)
{
  Words ids;
  for (int lane = 0; lane < lanes; ++lane)
  {
    ids[lane] = static_cast<std::uint32_t>(lane);
  }
  ids += shapetons.first;
  const PhiloxWords<Words> counter = { Words{},
                                       Words{} + static_cast<std::uint32_t>(random.step),
                                       Words{} + static_cast<std::uint32_t>(random.step >> 32),
                                       Words{} };
  for (std::size_t i = 0; i < shapetons.number; i += lanes)
  {
    PhiloxWords<Words> own = counter;
    own.a = ids + static_cast<std::uint32_t>(i);
    const auto words = Philox4x32<Words, Multiply>(random.seed, own, Multiply());
    Integers   octant;
    Integers   empty = {};
    Floats     s;
    Angle      theta;
    if constexpr (VSampling == Sampling::Uniform)
    {
      empty = LoadTraps(surroundings.records, shapetons.voxel + i);
      octant = (Integers)(words.a & 7U);
      s = ToUnit(words.b);
      theta.cosine = ToUnit(words.c);
      theta.sine = SquareRoot((1.0F - theta.cosine) * (1.0F + theta.cosine));
    }
    else
    {
      const Weights weights = LoadWeights(surroundings.records, shapetons.voxel + i);
      const Octant  drawn = DrawOctant(weights, ToUnit(words.a));
      octant = drawn.octant;
      empty = drawn.empty;
      s = DrawPhi(drawn.w1, drawn.w2, drawn.w3, ToUnit(words.b));
      const Floats across = drawn.w2 + (drawn.w3 - drawn.w2) * s;
      theta = VSampling == Sampling::SolidAngle
                ? DrawThetaBySolidAngle(drawn.w1, across, ToUnit(words.c), ToUnit(words.d), table)
                : DrawThetaBySectorArea(drawn.w1, across, ToUnit(words.c));
    }
    const Floats zero = {};
    Store(directions.x + i, empty ? zero : WithSign(theta.cosine, octant));
    Store(directions.y + i, empty ? zero : WithSign(theta.sine * SineOfQuarter(1.0F - s), octant >> 1));
    Store(directions.z + i, empty ? zero : WithSign(theta.sine * SineOfQuarter(s), octant >> 2));
  }
}

/** Folds a place at the borders 0 and `size`, as often as needed, into [0, size). */
SHAPETON_INLINE Floats
Reflect(Floats place, float size)
{
  const float  period = 2.0F * size;
  const Floats distance = Magnitude(place);
  const Floats turns = __builtin_convertvector(__builtin_convertvector(distance * (1.0F / period), Integers), Floats);
  const Floats rest = Magnitude(distance - turns * period);
  return Minimum(Minimum(rest, Magnitude(period - rest)), Broadcast(size * (1.0F - 6e-8F)));
}

void
MoveAll(const Surroundings & surroundings, const Shapetons & shapetons, const Directions & directions)
{
  const auto * const size = surroundings.size;
  for (std::size_t i = 0; i < shapetons.number; i += lanes)
  {
    const Floats x = Reflect(Load<Floats>(shapetons.x + i) + surroundings.step[0] * Load<Floats>(directions.x + i),
                             static_cast<float>(size[0]));
    const Floats y = Reflect(Load<Floats>(shapetons.y + i) + surroundings.step[1] * Load<Floats>(directions.y + i),
                             static_cast<float>(size[1]));
    const Floats z = Reflect(Load<Floats>(shapetons.z + i) + surroundings.step[2] * Load<Floats>(directions.z + i),
                             static_cast<float>(size[2]));
    Store(shapetons.x + i, x);
    Store(shapetons.y + i, y);
    Store(shapetons.z + i, z);
    const Integers row = __builtin_convertvector(z, Integers) * size[1] + __builtin_convertvector(y, Integers);
    Store(shapetons.voxel + i, row * size[0] + __builtin_convertvector(x, Integers));
    for (int lane = 0; lane < lanes; ++lane)
    {
      const std::size_t voxel = shapetons.voxel[i + lane];
      __builtin_prefetch(surroundings.records + voxel * RecordLength);
      __builtin_prefetch(surroundings.visits + voxel, 1);
    }
  }
}

constexpr Set kernels{ SHAPETON_STRING(SHAPETON_INSTRUCTION_SET),
                       DrawAll<Sampling::SolidAngle>,
                       DrawAll<Sampling::SectorArea>,
                       DrawAll<Sampling::Uniform>,
                       MoveAll };
} // namespace

const Set &
Set::Compiled(InstructionSets::SHAPETON_INSTRUCTION_SET)
{
  return kernels;
}
} // namespace ShapetonKernels
} // namespace shapeton
