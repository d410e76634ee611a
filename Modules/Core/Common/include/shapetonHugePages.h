#ifndef shapetonHugePages_h
#define shapetonHugePages_h

#include "ShapetonCommonExport.h"

#include <cstddef>

namespace shapeton
{
/** Allocates memory aligned to a cache line, and large memory to huge pages, which the system is requested to use:
 * large strides and random access then need hardly any address translation. To be freed by std::free(). Throws
 * std::bad_alloc. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT void *
AllocateHuge(std::size_t bytes);
} // namespace shapeton

#endif
