#ifndef shapetonPrintable_h
#define shapetonPrintable_h

#include "BaseExport.h"

#include <string>

namespace shapeton
{
/** The text as one line of valid UTF-8 without control characters: white space and control characters collapse into
 * single blanks, malformed bytes become '?'. File names may hold anything; terminals and XML may not.
 * \ingroup Base */
Base_EXPORT std::string
            Printable(const std::string & text);

/** `text` in double quotes, shortened when it is too long for a message. \ingroup Base */
Base_EXPORT std::string
            Quoted(const std::string & text);

/** The text without blanks, tabs, ends of lines and zeros at its begin and end. \ingroup Base */
Base_EXPORT std::string
            Trimmed(const std::string & text);

/** With a to z for A to Z, whatever the locale; other characters stay. \ingroup Base */
Base_EXPORT std::string
            LowerCase(std::string text);

/** A folder's name without slashes at its end, so that names can be made from it. \ingroup Base */
Base_EXPORT std::string
            WithoutTrailingSlashes(std::string path);
} // namespace shapeton

#endif
