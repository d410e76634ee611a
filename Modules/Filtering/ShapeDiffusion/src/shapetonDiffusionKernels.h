#ifndef shapetonDiffusionKernels_h
#define shapetonDiffusionKernels_h

#include "shapetonInstructionSets.h"

#include <cstddef>

namespace shapeton
{
/** The arithmetic of the diffusion on one row along x, for each instruction set: see InstructionSets. */
namespace DiffusionKernels
{
/** Where the edges and neighbours of a row lie. */
struct Edges
{
  const float *  x;
  const float *  y;
  const float *  z;
  std::ptrdiff_t strideY;
  std::ptrdiff_t strideZ;
};

/** Values of a row that an interpolation in time combines. */
constexpr std::size_t NumberOfNodes = 7;

struct Set
{
  const char * name;
  /** out = f + dt * sum_j c_ij (f_j - f_i): one explicit step. */
  void (*ExplicitStep)(const Edges & edges, const float * f, float * out, std::size_t n, float dt);
  /** The same with the rounding error of `f` carried along in `rest` (Kahan), for many steps. */
  void (*CompensatedStep)(const Edges & edges, const float * f, float * out, float * rest, std::size_t n, float dt);
  /** The Chebyshev recurrence in difference form: difference += scale * sum_j c_ij (f_j - f_i); out = f + difference.
   */
  void (
    *ChebyshevStep)(const Edges & edges, const float * f, float * out, float * difference, std::size_t n, float scale);
  /** sum += a * f + b * g. */
  void (*AddPair)(float * sum, const float * f, const float * g, std::size_t n, float a, float b);
  /** out = factor * f. */
  void (*Scale)(float * out, const float * f, std::size_t n, float factor);
  /** f = max(f, 0): an expansion of a field that is nowhere negative may fall below 0 by its error. */
  void (*ClampToZero)(float * f, std::size_t n);
  /** out = max(0, sum_k weights[k] * nodes[k]), k < NumberOfNodes. */
  void (*Combine)(float * out, const float * const * nodes, std::size_t n, const float * weights);
  /** Bits of a float in [2^-octaves, 1] as a bin number from 1 on, 0 below; see HeatHistogram. */
  void (*BinHeats)(const float * heats, unsigned short * bins, std::size_t n);

  static const Set & Compiled(InstructionSets::Baseline);
  static const Set & Compiled(InstructionSets::Avx2);
  static const Set & Compiled(InstructionSets::Avx512);
};

/** Within its life, results too small for a normal float count as 0 in this thread: heat that has left would otherwise
 * slow every step by a factor of ten. */
class FlushToZero
{
public:
  FlushToZero();
  ~FlushToZero();
  FlushToZero(const FlushToZero &) = delete;
  FlushToZero &
  operator=(const FlushToZero &) = delete;

private:
  unsigned int m_Saved;
};
} // namespace DiffusionKernels
} // namespace shapeton

#endif
