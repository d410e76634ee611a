#ifndef itkFileErrors_h
#define itkFileErrors_h

#include <string>

namespace itk
{
/** Throws InputError with the reason of `error` (an errno) and what to do. */
[[noreturn]] void
ThrowCannotRead(const std::string & path, int error);

/** Throws OutputError. */
[[noreturn]] void
ThrowCannotWrite(const std::string & path, int error);
[[noreturn]] void
ThrowCannotWrite(const std::string & path, const std::string & reason, const std::string & advice);
} // namespace itk

#endif
