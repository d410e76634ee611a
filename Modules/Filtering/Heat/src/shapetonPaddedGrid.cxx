#include "shapetonPaddedGrid.h"
#include "shapetonHugePages.h"

#include <cstdlib>
#include <cstring>
#include <new>

namespace shapeton
{
PaddedField::PaddedField(const PaddedGrid & grid, Memory memory)
{
  const std::size_t bytes = grid.GetLength() * sizeof(float);
  if (memory == Memory::OnDemand)
  {
    m_Data.reset(static_cast<float *>(std::calloc(bytes, 1)));
    if (!m_Data)
    {
      throw std::bad_alloc();
    }
    return;
  }
  m_Data.reset(static_cast<float *>(AllocateHuge(bytes)));
  std::memset(m_Data.get(), 0, bytes);
}

void
PaddedField::Free::operator()(float * data) const
{
  std::free(data);
}
} // namespace shapeton
