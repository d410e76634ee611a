#include <cstdlib>
#include <new>

#ifdef __linux__
#  include <malloc.h>
#  include <sys/mman.h>
#endif

// The address sanitizer keeps its own books of new and delete.
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
/** Large memory of a tool comes on huge pages, where the system has them: volumes and graphs are walked through in all
 * directions, and most of the time would go into the translation of addresses. Takes the place of the operator of the
 * standard library in every program that is linked with this library; memory is freed as ever. */
__attribute__((visibility("default"))) void *
operator new(std::size_t size)
{
  constexpr std::size_t page = std::size_t{ 1 } << 21;
  constexpr std::size_t large = 4 * page;
  // A fixed threshold: glibc would raise its own to 32 MB, and large memory that is freed would stay with the process.
  // Small memory may stay: given back at each chance, its pages would be taken and cleared again and again.
  static const bool isKnown = mallopt(M_MMAP_THRESHOLD, large) != 0 && mallopt(M_TRIM_THRESHOLD, 8 * large) != 0;
  const bool        isLarge = isKnown && size >= large;
  void * const      memory = isLarge ? std::aligned_alloc(page, size) : std::malloc(size + !size);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  if (isLarge)
  {
    madvise(memory, size, MADV_HUGEPAGE);
  }
  return memory;
}
#endif
