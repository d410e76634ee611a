#ifndef shapetonSha256_h
#define shapetonSha256_h

#include "ShapetonReportExport.h"

#include <string>

namespace shapeton
{
/** SHA-256 of a file as 64 lower-case hexadecimal digits. Throws InputError if the file cannot be read.
 * \ingroup ShapetonReport */
ShapetonReport_EXPORT std::string
                      Sha256OfFile(const std::string & path);

/** SHA-256 of a byte string as 64 lower-case hexadecimal digits.
 * \ingroup ShapetonReport */
ShapetonReport_EXPORT std::string
                      Sha256OfBytes(const std::string & bytes);
} // namespace shapeton

#endif
