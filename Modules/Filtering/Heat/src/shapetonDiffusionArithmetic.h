#ifndef shapetonDiffusionArithmetic_h
#define shapetonDiffusionArithmetic_h

#include "shapetonHeatHistogram.h"
#include "shapetonHostDevice.h"

#include <cstddef>

namespace shapeton
{
/** Memory offsets of the edges and neighbors of a row. */
struct DiffusionEdges
{
  const float *  x;
  const float *  y;
  const float *  z;
  std::ptrdiff_t strideY;
  std::ptrdiff_t strideZ;
};

/** The diffusion arithmetic of a voxel `i`, shared by all instruction sets and GPU kernels. */
namespace DiffusionArithmetic
{
/** Values of a row for interpolation in time. */
constexpr std::size_t NumberOfNodes = 13;

/** Values of a voxel and of its six neighbors. */
struct Neighborhood
{
  float center;
  float left;
  float right;
  float front;
  float back;
  float below;
  float above;
};

/** Net inflow to a voxel from its six neighbors: sum_j c_ij (f_j - f_i). \equation{2.2} */
SHAPETON_HOST_DEVICE float
Flow(const DiffusionEdges & e, const Neighborhood & f, std::size_t i)
{
  const float alongX = e.x[i] * (f.right - f.center) + (e.x - 1)[i] * (f.left - f.center);
  const float alongY = e.y[i] * (f.back - f.center) + (e.y - e.strideY)[i] * (f.front - f.center);
  const float alongZ = e.z[i] * (f.above - f.center) + (e.z - e.strideZ)[i] * (f.below - f.center);
  return (alongX + alongY) + alongZ;
}

SHAPETON_HOST_DEVICE float
Flow(const DiffusionEdges & e, const float * f, std::size_t i)
{
  return Flow(
    e,
    Neighborhood{
      f[i], (f - 1)[i], f[i + 1], (f - e.strideY)[i], (f + e.strideY)[i], (f - e.strideZ)[i], (f + e.strideZ)[i] },
    i);
}

/** out = f + dt * sum_j c_ij (f_j - f_i): one explicit step. */
SHAPETON_HOST_DEVICE void
ExplicitStep(const DiffusionEdges & edges, const float * f, float * out, std::size_t i, float dt)
{
  out[i] = f[i] + dt * Flow(edges, f, i);
}

/** One explicit step with compensation of the rounding error of `f` in `rest` (Kahan), for many steps. */
SHAPETON_HOST_DEVICE void
CompensatedStep(const DiffusionEdges & edges, const float * f, float * out, float * rest, std::size_t i, float dt)
{
  const float step = dt * Flow(edges, f, i) + rest[i];
  const float sum = f[i] + step;
  rest[i] = step - (sum - f[i]);
  out[i] = sum;
}

/** The Chebyshev recurrence in difference form: difference += scale * sum_j c_ij (f_j - f_i); out = f + difference. */
SHAPETON_HOST_DEVICE float
NextDifference(float difference, float scale, float flow)
{
  return difference + scale * flow;
}

SHAPETON_HOST_DEVICE void
ChebyshevStep(const DiffusionEdges & edges,
              const float *          f,
              float *                out,
              float *                difference,
              std::size_t            i,
              float                  scale)
{
  const float next = NextDifference(difference[i], scale, Flow(edges, f, i));
  difference[i] = next;
  out[i] = f[i] + next;
}

/** sum + (a * f + b * g). */
SHAPETON_HOST_DEVICE float
WithPair(float sum, float f, float g, float a, float b)
{
  return sum + (a * f + b * g);
}

SHAPETON_HOST_DEVICE void
AddPair(float * sum, const float * f, const float * g, std::size_t i, float a, float b)
{
  sum[i] = WithPair(sum[i], f[i], g[i], a, b);
}

/** f = max(f, 0): an expansion of a non-negative field may be negative within its error. */
SHAPETON_HOST_DEVICE float
ClampedToZero(float heat)
{
  return heat > 0.0F ? heat : 0.0F;
}

/** max(0, sum_k weights[k] * nodes[k]), k < NumberOfNodes. */
SHAPETON_HOST_DEVICE float
Combined(const float * const * nodes, std::size_t i, const float * weights)
{
  constexpr std::size_t written = 13;
  static_assert(NumberOfNodes == written, "the sum below is written out");
  return ClampedToZero(
    (((weights[0] * nodes[0][i] + weights[1] * nodes[1][i]) + (weights[2] * nodes[2][i] + weights[3] * nodes[3][i])) +
     ((weights[4] * nodes[4][i] + weights[5] * nodes[5][i]) + (weights[6] * nodes[6][i] + weights[7] * nodes[7][i]))) +
    (((weights[8] * nodes[8][i] + weights[9] * nodes[9][i]) +
      (weights[10] * nodes[10][i] + weights[11] * nodes[11][i])) +
     weights[12] * nodes[12][i]));
}

/** Converts the bits of a float to a bin number: from 1 for floats in [2^-octaves, 1], 0 below; see HeatHistogram. */
SHAPETON_HOST_DEVICE unsigned short
BinOf(float heat)
{
  // The bits of a positive float are monotonic in its value, and linear within each octave.
  constexpr std::int32_t one = 0x3f800000;
  constexpr std::int32_t perOctave = 1 << 23;
  constexpr std::int32_t least = one - static_cast<std::int32_t>(HeatHistogram::Octaves) * perOctave;
  constexpr std::int32_t width = perOctave / static_cast<std::int32_t>(HeatHistogram::BinsPerOctave);
  constexpr std::int32_t last = static_cast<std::int32_t>(HeatHistogram::NumberOfBins) - 1;
  std::int32_t           bits;
  __builtin_memcpy(&bits, &heat, sizeof(bits));
  const std::int32_t bin = (bits - least + width) / width;
  return static_cast<unsigned short>(bits < least ? 0 : bin < last ? bin : last);
}

/** Whether a voxel has changed by more than `change` times its heat, or times `least` if it is colder. */
SHAPETON_HOST_DEVICE bool
HasMoved(const float * before, const float * after, std::size_t i, float change, float least)
{
  const float heat = after[i];
  const float difference = heat - before[i];
  return (difference < 0.0F ? -difference : difference) > change * (heat < least ? least : heat);
}
} // namespace DiffusionArithmetic
} // namespace shapeton

#endif
