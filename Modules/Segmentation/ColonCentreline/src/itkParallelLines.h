#ifndef itkParallelLines_h
#define itkParallelLines_h

#include "itkMultiThreaderBase.h"

namespace itk
{
/** Calls `body(i)` for 0 <= i < number, each once, in no certain order. The body must not throw. */
template <typename TBody>
void
ParallelLines(std::size_t number, const TBody & body)
{
  const auto threader = MultiThreaderBase::New();
  threader->ParallelizeArray(
    0, number, [&body](SizeValueType i) { body(static_cast<std::size_t>(i)); }, nullptr);
}
} // namespace itk

#endif
