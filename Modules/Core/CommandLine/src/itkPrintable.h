#ifndef itkPrintable_h
#define itkPrintable_h

#include <string>

namespace itk
{
/** The text as one line of valid UTF-8 without control characters: white space and control characters collapse into
 * single blanks, malformed bytes become '?'. File names may hold anything; terminals and XML may not. */
std::string
Printable(const std::string & text);

/** `text` in double quotes, shortened when it is too long for a message. */
std::string
Quoted(const std::string & text);
} // namespace itk

#endif
