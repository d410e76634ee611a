#ifndef shapetonDiffusionKernels_h
#define shapetonDiffusionKernels_h

#include "shapetonDiffusionArithmetic.h"
#include "shapetonInstructionSets.h"

#include <cstddef>

namespace shapeton
{
/** DiffusionArithmetic on a row along x, for each instruction set: see InstructionSets. */
namespace DiffusionKernels
{
using Edges = DiffusionEdges;

struct Set
{
  const char * name;
  void (*ExplicitStep)(const Edges & edges, const float * f, float * out, std::size_t n, float dt);
  void (*CompensatedStep)(const Edges & edges, const float * f, float * out, float * rest, std::size_t n, float dt);
  void (
    *ChebyshevStep)(const Edges & edges, const float * f, float * out, float * difference, std::size_t n, float scale);
  void (*AddPair)(float * sum, const float * f, const float * g, std::size_t n, float a, float b);
  /** out = factor * f. */
  void (*Scale)(float * out, const float * f, std::size_t n, float factor);
  void (*ClampToZero)(float * f, std::size_t n);
  void (*Combine)(float * out, const float * const * nodes, std::size_t n, const float * weights);
  void (*BinHeats)(const float * heats, unsigned short * bins, std::size_t n);

  static const Set & Compiled(InstructionSets::Baseline);
  static const Set & Compiled(InstructionSets::Avx2);
  static const Set & Compiled(InstructionSets::Avx512);
};

} // namespace DiffusionKernels
} // namespace shapeton

#endif
