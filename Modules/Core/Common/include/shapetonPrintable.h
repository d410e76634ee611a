#ifndef shapetonPrintable_h
#define shapetonPrintable_h

#include "ShapetonCommonExport.h"

#include <cstddef>
#include <string>

namespace shapeton
{
/** The text as one line of valid UTF-8: white space and control characters collapse into single blanks, malformed bytes
 * become '?'. File names may contain any bytes, but terminals and XML do not accept all of them.
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT std::string
                      Printable(const std::string & text);

/** Maximum number of bytes of faulty input quoted in an error message. \ingroup ShapetonCommon */
constexpr std::size_t LongestExcerpt = 40;

/** `text` in double quotes, shortened if it is too long for a message. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT std::string
                      Quoted(const std::string & text);

/** The text without leading and trailing blanks, tabs, line ends and zeros. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT std::string
                      Trimmed(const std::string & text);

/** Converts A to Z to lower case in any locale; other characters are unchanged. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT std::string
                      LowerCase(std::string text);

/** A folder name without trailing slashes. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT std::string
                      WithoutTrailingSlashes(std::string path);
} // namespace shapeton

#endif
