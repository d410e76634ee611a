#include "shapetonOperatingSystem.h"

#include <cstdlib>
#include <new>

#ifdef __linux__
#  include <malloc.h>
#endif

// The address sanitizer replaces new and delete itself.
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
/** Allocates large blocks of memory on huge pages, where supported: volumes and graphs are traversed in all directions,
 * and address translation would dominate the run time. Replaces the operators of the standard library in every program
 * linked with this library; memory is freed as usual. */
__attribute__((visibility("default"))) void *
operator new(std::size_t size)
{
  constexpr std::size_t page = std::size_t{ 1 } << 21;
  constexpr std::size_t large = 4 * page;
  // A fixed threshold, because glibc would raise it to 32 MB and keep large freed blocks in the process. Small blocks
  // are kept, because returning them would map and clear their pages repeatedly.
  static const bool isKnown = mallopt(M_MMAP_THRESHOLD, large) != 0 && mallopt(M_TRIM_THRESHOLD, 8 * large) != 0;
  const bool        isLarge = isKnown && size >= large;
  void * const      memory = isLarge ? std::aligned_alloc(page, size) : std::malloc(size + !size);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  if (isLarge)
  {
    shapeton::RequestHugePages(memory, size);
  }
  return memory;
}
#endif
