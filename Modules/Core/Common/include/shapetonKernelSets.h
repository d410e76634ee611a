#ifndef shapetonKernelSets_h
#define shapetonKernelSets_h

#include "shapetonInstructionSets.h"

#include <vector>

namespace shapeton
{
/** The kernel sets of a family that this CPU supports, from the baseline to the fastest; see InstructionSets. */
template <typename TSet>
std::vector<const TSet *>
KernelsOfThisCpu()
{
  std::vector<const TSet *> sets{ &TSet::Compiled(InstructionSets::Baseline()) };
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2"))
  {
    sets.push_back(&TSet::Compiled(InstructionSets::Avx2()));
  }
  if (__builtin_cpu_supports("avx512f"))
  {
    sets.push_back(&TSet::Compiled(InstructionSets::Avx512()));
  }
#endif
  return sets;
}

/** The fastest kernel set of a family that this CPU supports. */
template <typename TSet>
const TSet &
BestKernels()
{
  static const TSet & best = *KernelsOfThisCpu<TSet>().back();
  return best;
}
} // namespace shapeton

#endif
