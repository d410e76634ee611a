#ifndef shapetonFileErrors_h
#define shapetonFileErrors_h

#include "ShapetonCommonExport.h"

#include <string>

namespace shapeton
{
/** Throws InputError with the reason of `error` (an errno) and advice. \ingroup ShapetonCommon */
[[noreturn]] ShapetonCommon_EXPORT void
ThrowCannotRead(const std::string & path, int error);

/** Throws InputError with the path and what is wrong with it. \ingroup ShapetonCommon */
[[noreturn]] ShapetonCommon_EXPORT void
ThrowUnsuitable(const std::string & path, const std::string & reason);

/** Throws OutputError with the reason of `error` (an errno) and advice. \ingroup ShapetonCommon */
[[noreturn]] ShapetonCommon_EXPORT void
ThrowCannotWrite(const std::string & path, int error);

/** For a library that does not report why it failed. `error` is the errno set since before the attempt; if it is 0,
 * `otherwise` is the reason. */
[[noreturn]] ShapetonCommon_EXPORT void
ThrowCannotWrite(const std::string & path, int error, const std::string & otherwise);

/** Throws OutputError. \ingroup ShapetonCommon */
[[noreturn]] ShapetonCommon_EXPORT void
ThrowCannotWrite(const std::string & path, const std::string & reason, const std::string & advice);

/** Throws InputError if a run folder of VirtualColonoscopy was written when file names were spelled in British English,
 * which its stage `segmentation` shows. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT void
RequireCurrentFileNames(const std::string & runFolder);
} // namespace shapeton

#endif
