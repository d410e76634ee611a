#ifndef shapetonFileErrors_h
#define shapetonFileErrors_h

#include "ShapetonCommonExport.h"

#include <string>

namespace shapeton
{
/** Throws InputError with the description of `error` (an errno) and advice. \ingroup ShapetonCommon */
[[noreturn]] ShapetonCommon_EXPORT void
ThrowCannotRead(const std::string & path, int error);

/** Throws InputError with the path and the error. \ingroup ShapetonCommon */
[[noreturn]] ShapetonCommon_EXPORT void
ThrowUnsuitable(const std::string & path, const std::string & reason);

/** Throws OutputError with the description of `error` (an errno) and advice. \ingroup ShapetonCommon */
[[noreturn]] ShapetonCommon_EXPORT void
ThrowCannotWrite(const std::string & path, int error);

/** Use this for a library that does not report the reason for a failure. `error` is errno, which was set to 0 before
 * the call; if it is still 0, `otherwise` is the reason. */
[[noreturn]] ShapetonCommon_EXPORT void
ThrowCannotWrite(const std::string & path, int error, const std::string & otherwise);

/** Throws OutputError. \ingroup ShapetonCommon */
[[noreturn]] ShapetonCommon_EXPORT void
ThrowCannotWrite(const std::string & path, const std::string & reason, const std::string & advice);
} // namespace shapeton

#endif
