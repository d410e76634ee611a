#ifndef shapetonFileErrors_h
#define shapetonFileErrors_h

#include "BaseExport.h"

#include <string>

namespace shapeton
{
/** Throws InputError with the reason of `error` (an errno) and what to do. \ingroup Base */
[[noreturn]] Base_EXPORT void
ThrowCannotRead(const std::string & path, int error);

/** Throws InputError: the path and what is wrong there. \ingroup Base */
[[noreturn]] Base_EXPORT void
ThrowUnsuitable(const std::string & path, const std::string & reason);

/** Throws OutputError with the reason of `error` (an errno) and what to do. \ingroup Base */
[[noreturn]] Base_EXPORT void
ThrowCannotWrite(const std::string & path, int error);

/** Throws OutputError. \ingroup Base */
[[noreturn]] Base_EXPORT void
ThrowCannotWrite(const std::string & path, const std::string & reason, const std::string & advice);
} // namespace shapeton

#endif
