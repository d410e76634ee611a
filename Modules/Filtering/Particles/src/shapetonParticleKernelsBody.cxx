// Compiled once per instruction set: see shapetonInstructionSets.h.
#include "shapetonParticleArithmetic.h"

#if defined(__x86_64__)
#  include <immintrin.h>
#endif

namespace shapeton
{
namespace ParticleKernels
{
namespace
{
constexpr int lanes = SHAPETON_VECTOR_BYTES / 4;

template <typename TVector>
SHAPETON_HOST_DEVICE TVector
Load(const void * memory)
{
  TVector vector;
  __builtin_memcpy(&vector, memory, sizeof(vector));
  return vector;
}

template <typename TVector>
SHAPETON_HOST_DEVICE void
Store(void * memory, TVector vector)
{
  __builtin_memcpy(memory, &vector, sizeof(vector));
}

/** The number of shapetons in a vector. */
struct VectorLanes
{
  using Floats = float __attribute__((vector_size(SHAPETON_VECTOR_BYTES)));
  using Integers = std::int32_t __attribute__((vector_size(SHAPETON_VECTOR_BYTES)));
  using Words = std::uint32_t __attribute__((vector_size(SHAPETON_VECTOR_BYTES)));
  using Truth = Integers; // -1 if true

  struct Multiply
  {
    SHAPETON_HOST_DEVICE void
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

  SHAPETON_HOST_DEVICE static Floats
  ToFloats(Integers numbers)
  {
    return __builtin_convertvector(numbers, Floats);
  }
  SHAPETON_HOST_DEVICE static Integers
  Truncate(Floats numbers)
  {
    return __builtin_convertvector(numbers, Integers);
  }
  SHAPETON_HOST_DEVICE static Integers
  BitsOf(Floats numbers)
  {
    return (Integers)numbers;
  }
  SHAPETON_HOST_DEVICE static Floats
  FromBits(Integers bits)
  {
    return (Floats)bits;
  }
  SHAPETON_HOST_DEVICE static Integers
  Signed(Words words)
  {
    return (Integers)words;
  }
  SHAPETON_HOST_DEVICE static Words
  Unsigned(Integers numbers)
  {
    return (Words)numbers;
  }
  SHAPETON_HOST_DEVICE static Integers
  Number(Truth truth)
  {
    return -truth;
  }
  SHAPETON_HOST_DEVICE static Floats
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
  SHAPETON_HOST_DEVICE static Floats
  Gather(const float * entries, Integers entry)
  {
    Floats gathered;
    for (int lane = 0; lane < lanes; ++lane)
    {
      gathered[lane] = entries[entry[lane]];
    }
    return gathered;
  }
  SHAPETON_HOST_DEVICE static void
  LoadWeights(const std::uint16_t * records, const std::uint32_t * voxels, Floats weights[6])
  {
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
      weights[2 * axis] = ToFloats(pair & 0xffff);
      weights[2 * axis + 1] = ToFloats((Integers)((Words)pair >> 16));
    }
  }
  SHAPETON_HOST_DEVICE static Integers
  LoadMarks(const std::uint16_t * records, const std::uint32_t * voxels)
  {
    Integers marks;
    for (int lane = 0; lane < lanes; ++lane)
    {
      marks[lane] = records[static_cast<std::size_t>(voxels[lane]) * RecordLength + MarksOfRecord];
    }
    return marks;
  }
};

using Arithmetic = ParticleArithmetic<VectorLanes>;
using Floats = VectorLanes::Floats;
using Words = VectorLanes::Words;

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
  for (std::size_t i = 0; i < shapetons.number; i += lanes)
  {
    Floats direction[3];
    Arithmetic::DrawDirection<VSampling>(
      surroundings.records, shapetons.voxel + i, random, ids + static_cast<std::uint32_t>(i), table, direction);
    Store(directions.x + i, direction[0]);
    Store(directions.y + i, direction[1]);
    Store(directions.z + i, direction[2]);
  }
}

void
MoveAll(const Surroundings & surroundings, const Shapetons & shapetons, const Directions & directions)
{
  for (std::size_t i = 0; i < shapetons.number; i += lanes)
  {
    const Floats direction[3] = { Load<Floats>(directions.x + i),
                                  Load<Floats>(directions.y + i),
                                  Load<Floats>(directions.z + i) };
    Floats place[3] = { Load<Floats>(shapetons.x + i), Load<Floats>(shapetons.y + i), Load<Floats>(shapetons.z + i) };
    Store(shapetons.voxel + i, Arithmetic::MovePlace(surroundings, direction, place));
    Store(shapetons.x + i, place[0]);
    Store(shapetons.y + i, place[1]);
    Store(shapetons.z + i, place[2]);
    for (int lane = 0; lane < lanes; ++lane)
    {
      const std::size_t voxel = shapetons.voxel[i + lane];
      __builtin_prefetch(surroundings.records + voxel * RecordLength);
      __builtin_prefetch(surroundings.visits + voxel, 1);
    }
  }
}

constexpr Set kernels{ SHAPETON_STRING(SHAPETON_INSTRUCTION_SET),
                       { DrawAll<Sampling::SolidAngle>,
                         DrawAll<Sampling::SectorArea>,
                         DrawAll<Sampling::BinarySearch>,
                         DrawAll<Sampling::Uniform> },
                       MoveAll };
} // namespace

const Set &
Set::Compiled(InstructionSets::SHAPETON_INSTRUCTION_SET)
{
  return kernels;
}
} // namespace ParticleKernels
} // namespace shapeton
