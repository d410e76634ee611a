#ifndef shapetonParticleArithmetic_h
#define shapetonParticleArithmetic_h

#include "shapetonPhilox.h"
#include "shapetonParticleKernels.h"
#include "shapetonParticleMoments.h"

namespace shapeton
{
namespace ParticleKernels
{
/** Arithmetic of a shapeton step, shared by all instruction sets and GPU kernels.
 *
 * `TLanes` defines the number types: vectors, or scalars for one shapeton (ScalarLanes). It provides the types
 * Floats, Integers (32 bits), Words (unsigned) and Truth (result of a comparison), and the operations below that
 * have no operators. */
template <typename TLanes>
struct ParticleArithmetic
{
  using Floats = typename TLanes::Floats;
  using Integers = typename TLanes::Integers;
  using Words = typename TLanes::Words;
  using Truth = typename TLanes::Truth;

  /** Guard of a division by zero. */
  static constexpr float LeastDivisor = 1e-20F;
  /** The largest number below 1. */
  static constexpr float BelowOne = 1.0F - 6e-8F;

  SHAPETON_HOST_DEVICE static Floats
  Broadcast(float value)
  {
    return value - Floats{};
  }

  SHAPETON_HOST_DEVICE static Floats
  Maximum(Floats a, Floats b)
  {
    return a > b ? a : b;
  }

  SHAPETON_HOST_DEVICE static Floats
  Minimum(Floats a, Floats b)
  {
    return a < b ? a : b;
  }

  SHAPETON_HOST_DEVICE static Floats
  Magnitude(Floats a)
  {
    return TLanes::FromBits(TLanes::BitsOf(a) & 0x7fffffff);
  }

  SHAPETON_HOST_DEVICE static Floats
  SquareRoot(Floats a)
  {
    return TLanes::SquareRoot(a);
  }

  /** Cube root of non-negative numbers: an estimate from the exponent, and two steps of Halley's method. */
  SHAPETON_HOST_DEVICE static Floats
  CubeRoot(Floats a)
  {
    const Integers         third = TLanes::Truncate(TLanes::ToFloats(TLanes::BitsOf(a)) * (1.0F / 3.0F));
    constexpr std::int32_t twoThirdsOfOne = 709921077; // about, of the bits of 1.0F
    Floats                 root = TLanes::FromBits(third + twoThirdsOfOne);
    for (int iteration = 0; iteration < 2; ++iteration)
    {
      const Floats cube = root * root * root;
      root = root * (cube + 2.0F * a) / (2.0F * cube + a);
    }
    constexpr float least = 1e-30F;
    return a > least ? root : Broadcast(0.0F);
  }

  /** sin(pi/2 u) for u in [0, 1]. */
  SHAPETON_HOST_DEVICE static Floats
  SineOfQuarter(Floats u)
  {
    // Coefficients of the odd powers, close to those of Taylor's series.
    constexpr float a1 = 1.5707963F, a3 = -0.64596409F, a5 = 0.079692626F;
    constexpr float a7 = -0.0046817541F, a9 = 0.00016044118F, a11 = -3.5988432e-6F;
    const Floats    t = u * u;
    return u * (a1 + t * (a3 + t * (a5 + t * (a7 + t * (a9 + t * a11)))));
  }

  /** Numbers in (0, 1]. */
  SHAPETON_HOST_DEVICE static Floats
  ToUnit(Words words)
  {
    constexpr float values = 16777216.0F; // 2^24
    return (TLanes::ToFloats(TLanes::Signed(words >> 8)) + 1.0F) * (1.0F / values);
  }

  /** The value if bit 0 of `bit` is set, else its negative. */
  SHAPETON_HOST_DEVICE static Floats
  WithSign(Floats value, Integers bit)
  {
    return TLanes::FromBits(TLanes::BitsOf(value) ^ TLanes::Signed((TLanes::Unsigned(bit) & 1U) << 31 ^ 0x80000000U));
  }

  /** Unit of the weights of a record. */
  static constexpr float UnitOfWeights = 1.0F / 65535.0F;

  /** The six weights in that unit; except by binary search, directions depend only on their ratios. */
  struct Weights
  {
    Floats w[6];
  };

  static constexpr float moment0 = static_cast<float>(ParticleMoments::moment[0]);
  static constexpr float moment1 = static_cast<float>(ParticleMoments::moment[1]);
  static constexpr float moment2 = static_cast<float>(ParticleMoments::moment[2]);
  static constexpr float moment3 = static_cast<float>(ParticleMoments::moment[3]);

  /** The sampled octant and its three weights; bits 0, 1, 2 of `octant` mean +x, +y, +z. */
  struct Octant
  {
    Integers octant;
    Floats   w1;
    Floats   w2;
    Floats   w3;
    Truth    empty; ///< all weights are 0
  };

  /** Samples the octant by volume (8.6); `random` is in (0, 1]. */
  SHAPETON_HOST_DEVICE static Octant
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
      const Truth beyond = wanted > below;
      below += volumes[k];
      drawn.octant = beyond ? Integers{} + k : drawn.octant;
      drawn.w1 = beyond ? w[k & 1] : drawn.w1;
      drawn.w2 = beyond ? w[2 + (k >> 1 & 1)] : drawn.w2;
      drawn.w3 = beyond ? w[4 + (k >> 2)] : drawn.w3;
    }
    return drawn;
  }

  /** Coefficients of a cubic in s. */
  struct Cubic
  {
    Floats g0;
    Floats g1;
    Floats g2;
    Floats g3;
  };

  /** Density of s = 2 phi / pi, not normalized: the mean of R^3 over theta. */
  SHAPETON_HOST_DEVICE static Cubic
  DensityOfPhi(Floats w1, Floats w2, Floats w3)
  {
    const Floats b = w3 - w2;
    const Floats w11 = w1 * w1;
    const Floats w22 = w2 * w2;
    return { moment0 * w11 * w1 + moment1 * w11 * w2 + moment2 * w1 * w22 + moment3 * w22 * w2,
             b * (moment1 * w11 + 2.0F * moment2 * w1 * w2 + 3.0F * moment3 * w22),
             b * b * (moment2 * w1 + 3.0F * moment3 * w2),
             b * b * b * moment3 };
  }

  /** s = 2 phi / pi by partial volume: the zero of a quartic by three Newton steps. The start value is exact if the
   * weight of the first axis is merely an offset. Error of the distribution function 1e-6.
   *
   * \equation{8.1}
   *
   * \equation{8.2}
   *
   * \equation{8.5} as a polynomial in s. */
  SHAPETON_HOST_DEVICE static Floats
  DrawPhi(Floats w1, Floats w2, Floats w3, Floats random)
  {
    const Floats shift = 0.2789F * w1;
    const Floats e0 = w2 + shift;
    const Floats e1 = w3 + shift;
    const Floats e02 = e0 * e0;
    const Floats e12 = e1 * e1;
    const Floats e04 = e02 * e02;
    const Floats root = SquareRoot(SquareRoot(Maximum(Floats{}, e04 + random * (e12 * e12 - e04))));
    Floats s = random * ((e1 + e0) * (e12 + e02)) / Maximum((root + e0) * (root * root + e02), Broadcast(LeastDivisor));

    const auto [g0, g1, g2, g3] = DensityOfPhi(w1, w2, w3);
    const Floats wanted = random * (g0 + g1 * 0.5F + g2 * (1.0F / 3.0F) + g3 * 0.25F);
    for (int iteration = 0; iteration < 3; ++iteration)
    {
      s = Minimum(s, Broadcast(1.0F));
      const Floats below = s * (g0 + s * (g1 * 0.5F + s * (g2 * (1.0F / 3.0F) + s * g3 * 0.25F)));
      const Floats slope = g0 + s * (g1 + s * (g2 + s * g3));
      s = Minimum(Broadcast(1.0F), Maximum(Floats{}, s - (below - wanted) / Maximum(slope, Broadcast(LeastDivisor))));
    }
    return s;
  }

  struct Angle
  {
    Floats cosine;
    Floats sine;
  };

  /** Samples theta with density R^3 sin(theta). The cube of R = w1 (1 - u) + W u has four terms, and the distribution
   * of theta for a given term does not depend on the weights: one random number selects the term, the other is used to
   * look up theta. */
  SHAPETON_HOST_DEVICE static Angle
  DrawThetaBySolidAngle(Floats w1, Floats across, Floats random, Floats termRandom, const ThetaTable & table)
  {
    const Floats   term0 = moment0 * w1 * w1 * w1;
    const Floats   term1 = term0 + moment1 * w1 * w1 * across;
    const Floats   term2 = term1 + moment2 * w1 * across * across;
    const Floats   term3 = term2 + moment3 * across * across * across;
    const Floats   wanted = termRandom * term3;
    const Integers term =
      TLanes::Number(wanted > term0) + TLanes::Number(wanted > term1) + TLanes::Number(wanted > term2);
    const Truth    isHigh = random > 0.5F;
    const Floats   share = isHigh ? 1.0F - random : random;
    const Floats   place = SquareRoot(share * 2.0F) * static_cast<float>(ThetaTableSize);
    const Integers cell = TLanes::Truncate(Minimum(place, Broadcast(ThetaTableSize - 1.0F)));
    const Floats   within = place - TLanes::ToFloats(cell);
    const Integers entry = (term + TLanes::Number(isHigh) * 4) * (ThetaTableSize + 1) + cell;
    const float *  entries = &table.low[0][0];
    const Floats   left = TLanes::Gather(entries, entry);
    const Floats   right = TLanes::Gather(entries + 1, entry);
    const Floats   value = left + within * (right - left);
    const Floats   rest = 1.0F - value;
    Angle          angle;
    angle.cosine = isHigh ? value : rest;
    angle.sine = SquareRoot(Maximum(Floats{}, isHigh ? rest * (1.0F + value) : value * (1.0F + rest)));
    return angle;
  }

  /** Samples theta by sector area (8.7), as published. */
  SHAPETON_HOST_DEVICE static Angle
  DrawThetaBySectorArea(Floats w1, Floats across, Floats random)
  {
    // Scaled by the larger weight, so that cubes neither overflow nor underflow.
    const Floats scale = 1.0F / Maximum(Maximum(w1, across), Broadcast(LeastDivisor));
    const Floats a = w1 * scale;
    const Floats b = across * scale;
    const Floats aaa = a * a * a;
    const Floats root = CubeRoot(Maximum(Floats{}, aaa + random * (b * b * b - aaa)));
    const Floats u =
      Minimum(Broadcast(1.0F),
              random * (b * b + b * a + a * a) / Maximum(root * root + root * a + a * a, Broadcast(LeastDivisor)));
    return { SineOfQuarter(1.0F - u), SineOfQuarter(u) };
  }

  /** The angle, in units of pi/2, at which a polynomial without a constant term has a value, by bisection as published:
   * until the value is within 0.01.
   *
   * \equation{8.8} and \equation{8.9} */
  SHAPETON_HOST_DEVICE static Floats
  SearchAngle(const Floats coefficients[4], Floats wanted)
  {
    constexpr float tolerance = 0.01F;
    // Enough: the largest slope, pi/4 per pi/2, times the last error of the angle, 2^-7, is less than the tolerance.
    constexpr int iterations = 6;
    Floats        u = Broadcast(0.5F);
    float         change = 0.25F;
    for (int iteration = 0; iteration < iterations; ++iteration, change *= 0.5F)
    {
      const Floats value = u * (coefficients[0] + u * (coefficients[1] + u * (coefficients[2] + u * coefficients[3])));
      const Floats next = wanted < value ? u - change : u + change;
      u = Magnitude(wanted - value) < tolerance ? u : next;
    }
    return u;
  }

  /** s = 2 phi / pi, searched by volume (8.5). */
  SHAPETON_HOST_DEVICE static Floats
  SearchPhi(Floats w1, Floats w2, Floats w3, Floats random)
  {
    const Cubic density = DensityOfPhi(w1, w2, w3);
    // Integrated along s, times pi/2 / 3.
    constexpr float ofVolume = 0.52359878F;
    const Floats    coefficients[4] = { ofVolume * density.g0,
                                        (0.5F * ofVolume) * density.g1,
                                        (ofVolume / 3.0F) * density.g2,
                                        (0.25F * ofVolume) * density.g3 };
    return SearchAngle(coefficients, random * (coefficients[0] + coefficients[1] + coefficients[2] + coefficients[3]));
  }

  /** u = 2 theta / pi, searched by area (8.7). */
  SHAPETON_HOST_DEVICE static Floats
  SearchTheta(Floats w1, Floats across, Floats random)
  {
    constexpr float ofArea = 0.78539816F; // pi/4
    const Floats    b = across - w1;
    const Floats    coefficients[4] = { ofArea * w1 * w1, ofArea * w1 * b, (ofArea / 3.0F) * b * b, Floats{} };
    return SearchAngle(coefficients, random * (coefficients[0] + coefficients[1] + coefficients[2]));
  }

  /** Samples a direction from the weights of a shapeton's voxel; the zero vector if all weights are 0.
   *
   * \equation{3.6} as `across`.
   *
   * \equation{3.7}
   *
   * \equation{8.4} as `across`. */
  template <Sampling VSampling>
  SHAPETON_HOST_DEVICE static void
  DrawDirection(const std::uint16_t * records,
                const std::uint32_t * voxels,
                const Random &        random,
                Words                 shapetons,
                const ThetaTable &    table,
                Floats                direction[3])
  {
    const PhiloxWords<Words> counter = { shapetons,
                                         Words{} + static_cast<std::uint32_t>(random.step),
                                         Words{} + static_cast<std::uint32_t>(random.step >> 32),
                                         Words{} };
    const auto words = Philox4x32<Words, typename TLanes::Multiply>(random.seed, counter, typename TLanes::Multiply());
    Integers   octant;
    Truth      empty;
    Floats     s;
    Angle      theta;
    if constexpr (VSampling == Sampling::Uniform)
    {
      empty = (TLanes::LoadMarks(records, voxels) & TrapMark) != 0;
      octant = TLanes::Signed(words.a & 7U);
      s = ToUnit(words.b);
      theta.cosine = ToUnit(words.c);
      theta.sine = SquareRoot((1.0F - theta.cosine) * (1.0F + theta.cosine));
    }
    else
    {
      Weights weights;
      TLanes::LoadWeights(records, voxels, weights.w);
      const Octant drawn = DrawOctant(weights, ToUnit(words.a));
      octant = drawn.octant;
      empty = drawn.empty;
      if constexpr (VSampling == Sampling::BinarySearch)
      {
        const Floats w1 = drawn.w1 * UnitOfWeights;
        const Floats w2 = drawn.w2 * UnitOfWeights;
        const Floats w3 = drawn.w3 * UnitOfWeights;
        s = SearchPhi(w1, w2, w3, ToUnit(words.b));
        const Floats u = SearchTheta(w1, w2 + (w3 - w2) * s, ToUnit(words.c));
        theta = { SineOfQuarter(1.0F - u), SineOfQuarter(u) };
      }
      else
      {
        s = DrawPhi(drawn.w1, drawn.w2, drawn.w3, ToUnit(words.b));
        const Floats across = drawn.w2 + (drawn.w3 - drawn.w2) * s;
        theta = VSampling == Sampling::SolidAngle
                  ? DrawThetaBySolidAngle(drawn.w1, across, ToUnit(words.c), ToUnit(words.d), table)
                  : DrawThetaBySectorArea(drawn.w1, across, ToUnit(words.c));
      }
    }
    const Floats zero = {};
    direction[0] = empty ? zero : WithSign(theta.cosine, octant);
    direction[1] = empty ? zero : WithSign(theta.sine * SineOfQuarter(1.0F - s), octant >> 1);
    direction[2] = empty ? zero : WithSign(theta.sine * SineOfQuarter(s), octant >> 2);
  }

  /** Reflects a position at the borders 0 and `size`, repeatedly if needed, into [0, size). */
  SHAPETON_HOST_DEVICE static Floats
  Reflect(Floats place, float size)
  {
    const float  period = 2.0F * size;
    const Floats distance = Magnitude(place);
    const Floats turns = TLanes::ToFloats(TLanes::Truncate(distance * (1.0F / period)));
    const Floats rest = Magnitude(distance - turns * period);
    return Minimum(Minimum(rest, Magnitude(period - rest)), Broadcast(size * BelowOne));
  }

  /** Moves a shapeton by one step, reflected at the border of the volume; returns its voxel. */
  SHAPETON_HOST_DEVICE static Integers
  MovePlace(const Surroundings & surroundings, const Floats direction[3], Floats place[3])
  {
    const auto * const size = surroundings.size;
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] = Reflect(place[axis] + surroundings.step[axis] * direction[axis], static_cast<float>(size[axis]));
    }
    const Integers row = TLanes::Truncate(place[2]) * size[1] + TLanes::Truncate(place[1]);
    return row * size[0] + TLanes::Truncate(place[0]);
  }
};

/** Scalar operations for one shapeton. */
struct ScalarLanes
{
  using Floats = float;
  using Integers = std::int32_t;
  using Words = std::uint32_t;
  using Truth = bool;
  using Multiply = PhiloxMultiply;

  SHAPETON_HOST_DEVICE static float
  ToFloats(std::int32_t number)
  {
    return static_cast<float>(number);
  }
  SHAPETON_HOST_DEVICE static std::int32_t
  Truncate(float number)
  {
    return static_cast<std::int32_t>(number);
  }
  SHAPETON_HOST_DEVICE static std::int32_t
  BitsOf(float number)
  {
    std::int32_t bits;
    __builtin_memcpy(&bits, &number, sizeof(bits));
    return bits;
  }
  SHAPETON_HOST_DEVICE static float
  FromBits(std::int32_t bits)
  {
    float number;
    __builtin_memcpy(&number, &bits, sizeof(number));
    return number;
  }
  SHAPETON_HOST_DEVICE static std::int32_t
  Signed(std::uint32_t word)
  {
    return static_cast<std::int32_t>(word);
  }
  SHAPETON_HOST_DEVICE static std::uint32_t
  Unsigned(std::int32_t number)
  {
    return static_cast<std::uint32_t>(number);
  }
  /** 1 if true. */
  SHAPETON_HOST_DEVICE static std::int32_t
  Number(bool truth)
  {
    return truth ? 1 : 0;
  }
  SHAPETON_HOST_DEVICE static float
  SquareRoot(float number)
  {
#if defined(__CUDA_ARCH__)
    return sqrtf(number); // correctly rounded, compiled with --prec-sqrt=true
#else
    return __builtin_sqrtf(number);
#endif
  }
  SHAPETON_HOST_DEVICE static float
  Gather(const float * entries, std::int32_t entry)
  {
    return entries[entry];
  }
  SHAPETON_HOST_DEVICE static void
  LoadWeights(const std::uint16_t * records, const std::uint32_t * voxels, float weights[6])
  {
    const std::uint16_t * const record = records + static_cast<std::size_t>(*voxels) * RecordLength;
    for (int edge = 0; edge < 6; ++edge)
    {
      weights[edge] = static_cast<float>(record[edge]);
    }
  }
  SHAPETON_HOST_DEVICE static std::int32_t
  LoadMarks(const std::uint16_t * records, const std::uint32_t * voxels)
  {
    return records[static_cast<std::size_t>(*voxels) * RecordLength + MarksOfRecord];
  }
};
} // namespace ParticleKernels
} // namespace shapeton

#endif
