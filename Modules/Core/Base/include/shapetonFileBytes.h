#ifndef shapetonFileBytes_h
#define shapetonFileBytes_h

#include "BaseExport.h"

#include <string>

namespace shapeton
{
/** All bytes of a file. Throws InputError when it cannot be read.
 * \ingroup Base */
Base_EXPORT std::string
            ReadFileBytes(const std::string & path);

/** Makes a file of these bytes, or replaces what it held. Throws OutputError, also when the disk is full.
 * \ingroup Base */
Base_EXPORT void
WriteFileBytes(const std::string & path, const std::string & bytes);
} // namespace shapeton

#endif
