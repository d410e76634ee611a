#include "itkPaddedGrid.h"

#include <cstdlib>
#include <cstring>
#include <new>

#ifdef __linux__
#  include <sys/mman.h>
#endif

namespace itk
{
PaddedField::PaddedField(const PaddedGrid & grid)
{
  // The sweeps walk along z with strides of many pages: huge pages spare most of the address translation.
  constexpr std::size_t page = std::size_t{ 1 } << 21;
  const std::size_t     alignment = grid.GetLength() * sizeof(float) < page ? 64 : page;
  const std::size_t     bytes = (grid.GetLength() * sizeof(float) + alignment - 1) / alignment * alignment;
  m_Data.reset(static_cast<float *>(std::aligned_alloc(alignment, bytes)));
  if (!m_Data)
  {
    throw std::bad_alloc();
  }
#ifdef __linux__
  if (alignment == page)
  {
    madvise(m_Data.get(), bytes, MADV_HUGEPAGE);
  }
#endif
  std::memset(m_Data.get(), 0, bytes);
}

void
PaddedField::Free::operator()(float * data) const
{
  std::free(data);
}
} // namespace itk
