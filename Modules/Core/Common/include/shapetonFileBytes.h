#ifndef shapetonFileBytes_h
#define shapetonFileBytes_h

#include "ShapetonCommonExport.h"

#include <string>

namespace shapeton
{
/** Reads all bytes of a file. Throws InputError if it cannot be read.
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT std::string
                      ReadFileBytes(const std::string & path);

/** Writes these bytes to a file, replacing any previous content. Throws OutputError, also if the disk is full.
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT void
WriteFileBytes(const std::string & path, const std::string & bytes);
} // namespace shapeton

#endif
