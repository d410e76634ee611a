#include "shapetonHugePages.h"

#include "shapetonOperatingSystem.h"

#include <cstdlib>
#include <new>

namespace shapeton
{
void *
AllocateHuge(std::size_t bytes)
{
  constexpr std::size_t page = std::size_t{ 1 } << 21;
  const std::size_t     alignment = bytes < page ? 64 : page;
  const std::size_t     whole = (bytes + alignment - 1) / alignment * alignment;
  void * const          memory = std::aligned_alloc(alignment, whole);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  if (alignment == page)
  {
    RequestHugePages(memory, whole);
  }
  return memory;
}
} // namespace shapeton
