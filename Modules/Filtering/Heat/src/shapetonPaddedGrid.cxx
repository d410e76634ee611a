#include "shapetonPaddedGrid.h"
#include "shapetonHugePages.h"

#include <cstdlib>
#include <cstring>

namespace shapeton
{
PaddedField::PaddedField(const PaddedGrid & grid)
  : m_Data(static_cast<float *>(AllocateHuge(grid.GetLength() * sizeof(float))))
{
  std::memset(m_Data.get(), 0, grid.GetLength() * sizeof(float));
}

void
PaddedField::Free::operator()(float * data) const
{
  std::free(data);
}
} // namespace shapeton
