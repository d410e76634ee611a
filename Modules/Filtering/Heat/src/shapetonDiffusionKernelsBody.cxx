// Compiled once per instruction set: see shapetonInstructionSets.h.
#include "shapetonDiffusionKernels.h"

// The rows that a kernel reads and writes overlap only for in-place updates.
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
void
ExplicitStep(const Edges & edges, const float * f, float * out, std::size_t n, float dt)
{
  SHAPETON_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i)
  {
    DiffusionArithmetic::ExplicitStep(edges, f, out, i, dt);
  }
}

void
CompensatedStep(const Edges & edges, const float * f, float * out, float * rest, std::size_t n, float dt)
{
  SHAPETON_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i)
  {
    DiffusionArithmetic::CompensatedStep(edges, f, out, rest, i, dt);
  }
}

void
ChebyshevStep(const Edges & edges, const float * f, float * out, float * difference, std::size_t n, float scale)
{
  SHAPETON_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i)
  {
    DiffusionArithmetic::ChebyshevStep(edges, f, out, difference, i, scale);
  }
}

void
AddPair(float * sum, const float * f, const float * g, std::size_t n, float a, float b)
{
  SHAPETON_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i)
  {
    DiffusionArithmetic::AddPair(sum, f, g, i, a, b);
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
    f[i] = DiffusionArithmetic::ClampedToZero(f[i]);
  }
}

void
Combine(float * out, const float * const * nodes, std::size_t n, const float * weights)
{
  // Local copies: the compiler can assume that `out` does not alias them.
  float         w[DiffusionArithmetic::NumberOfNodes];
  const float * rows[DiffusionArithmetic::NumberOfNodes];
  std::copy(weights, weights + DiffusionArithmetic::NumberOfNodes, w);
  std::copy(nodes, nodes + DiffusionArithmetic::NumberOfNodes, rows);
  SHAPETON_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i)
  {
    out[i] = DiffusionArithmetic::Combined(rows, i, w);
  }
}

void
BinHeats(const float * heats, unsigned short * bins, std::size_t n)
{
  SHAPETON_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i)
  {
    bins[i] = DiffusionArithmetic::BinOf(heats[i]);
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
