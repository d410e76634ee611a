// Compiled once for each instruction set: see shapetonInstructionSets.h.
#include "shapetonDiffusionKernels.h"
#include "shapetonHeatHistogram.h"

// The rows that a kernel reads and writes never overlap but where it reads and writes the same element.
#if defined(__clang__)
#  define SHAPETON_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#  define SHAPETON_INDEPENDENT _Pragma("GCC ivdep")
#else
#  define SHAPETON_INDEPENDENT
#endif

namespace shapeton
{
namespace DiffusionKernels
{
namespace
{
/** What flows into a voxel from its six neighbours: sum_j c_ij (f_j - f_i). \equation{2.2} */
__attribute__((always_inline)) inline float
Flow(const Edges & e, const float * f, std::size_t i)
{
  const float heat = f[i];
  const float alongX = e.x[i] * (f[i + 1] - heat) + (e.x - 1)[i] * ((f - 1)[i] - heat);
  const float alongY = e.y[i] * ((f + e.strideY)[i] - heat) + (e.y - e.strideY)[i] * ((f - e.strideY)[i] - heat);
  const float alongZ = e.z[i] * ((f + e.strideZ)[i] - heat) + (e.z - e.strideZ)[i] * ((f - e.strideZ)[i] - heat);
  return (alongX + alongY) + alongZ;
}

void
ExplicitStep(const Edges & edges, const float * f, float * out, std::size_t n, float dt)
{
  SHAPETON_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i)
  {
    out[i] = f[i] + dt * Flow(edges, f, i);
  }
}

void
CompensatedStep(const Edges & edges, const float * f, float * out, float * rest, std::size_t n, float dt)
{
  SHAPETON_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i)
  {
    const float step = dt * Flow(edges, f, i) + rest[i];
    const float sum = f[i] + step;
    rest[i] = step - (sum - f[i]);
    out[i] = sum;
  }
}

void
ChebyshevStep(const Edges & edges, const float * f, float * out, float * difference, std::size_t n, float scale)
{
  SHAPETON_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i)
  {
    const float next = difference[i] + scale * Flow(edges, f, i);
    difference[i] = next;
    out[i] = f[i] + next;
  }
}

void
AddPair(float * sum, const float * f, const float * g, std::size_t n, float a, float b)
{
  SHAPETON_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i)
  {
    sum[i] += a * f[i] + b * g[i];
  }
}

void
Scale(float * out, const float * f, std::size_t n, float factor)
{
  SHAPETON_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i)
  {
    out[i] = factor * f[i];
  }
}

void
ClampToZero(float * f, std::size_t n)
{
  SHAPETON_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i)
  {
    f[i] = f[i] > 0.0F ? f[i] : 0.0F;
  }
}

void
Combine(float * out, const float * const * nodes, std::size_t n, const float * weights)
{
  static_assert(NumberOfNodes == 7, "the sum below is written out");
  const float w0 = weights[0], w1 = weights[1], w2 = weights[2], w3 = weights[3];
  const float w4 = weights[4], w5 = weights[5], w6 = weights[6];
  SHAPETON_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i)
  {
    const float sum = ((w0 * nodes[0][i] + w1 * nodes[1][i]) + (w2 * nodes[2][i] + w3 * nodes[3][i])) +
                      ((w4 * nodes[4][i] + w5 * nodes[5][i]) + w6 * nodes[6][i]);
    out[i] = sum > 0.0F ? sum : 0.0F;
  }
}

void
BinHeats(const float * heats, unsigned short * bins, std::size_t n)
{
  // The bits of a positive float grow with its value, and evenly within each octave.
  constexpr std::int32_t one = 0x3f800000;
  constexpr std::int32_t perOctave = 1 << 23;
  constexpr std::int32_t least = one - static_cast<std::int32_t>(HeatHistogram::Octaves) * perOctave;
  constexpr std::int32_t width = perOctave / static_cast<std::int32_t>(HeatHistogram::BinsPerOctave);
  constexpr std::int32_t last = static_cast<std::int32_t>(HeatHistogram::NumberOfBins) - 1;
  SHAPETON_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i)
  {
    std::int32_t bits;
    __builtin_memcpy(&bits, heats + i, sizeof(bits));
    const std::int32_t bin = (bits - least + width) / width;
    bins[i] = static_cast<unsigned short>(bits < least ? 0 : bin < last ? bin : last);
  }
}

constexpr Set kernels{ SHAPETON_STRING(SHAPETON_INSTRUCTION_SET),
                       ExplicitStep,
                       CompensatedStep,
                       ChebyshevStep,
                       AddPair,
                       Scale,
                       ClampToZero,
                       Combine,
                       BinHeats };
} // namespace

const Set &
Set::Compiled(InstructionSets::SHAPETON_INSTRUCTION_SET)
{
  return kernels;
}
} // namespace DiffusionKernels
} // namespace shapeton
