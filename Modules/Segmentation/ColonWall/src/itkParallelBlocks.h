#ifndef itkParallelBlocks_h
#define itkParallelBlocks_h

#include "itkMultiThreaderBase.h"

#include <algorithm>

namespace itk
{
/** Calls `body(i)` for 0 <= i < number in blocks on ITK's threads, in no certain order; `body` does not throw. */
template <typename TBody>
void
ParallelForEach(std::size_t number, const TBody & body)
{
  constexpr std::size_t blockSize = 4096;
  MultiThreaderBase::New()->ParallelizeArray(
    0,
    (number + blockSize - 1) / blockSize,
    [&](SizeValueType block) {
      const std::size_t end = std::min(number, (block + 1) * blockSize);
      for (std::size_t i = block * blockSize; i < end; ++i)
      {
        body(i);
      }
    },
    nullptr);
}
} // namespace itk

#endif
