#ifndef shapetonHugePages_h
#define shapetonHugePages_h

#include <cstddef>

namespace shapeton
{
/** Memory aligned to a cache line; where it is large, to huge pages, which the system is asked to use:
 * strides of many pages and random access then need hardly any address translation. To be freed by std::free(). Throws
 * std::bad_alloc. */
void *
AllocateHuge(std::size_t bytes);
} // namespace shapeton

#endif
