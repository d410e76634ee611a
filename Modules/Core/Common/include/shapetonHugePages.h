#ifndef shapetonHugePages_h
#define shapetonHugePages_h

#include "ShapetonCommonExport.h"

#include <cstddef>

namespace shapeton
{
/** Allocates memory aligned to a cache line. Large blocks are aligned to huge pages, which are requested from the
 * system to reduce address translation for large strides and random access. Free it with std::free(). Throws
 * std::bad_alloc.
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT void *
AllocateHuge(std::size_t bytes);
} // namespace shapeton

#endif
