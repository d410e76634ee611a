#ifndef shapetonBase64Text_h
#define shapetonBase64Text_h

#include "ShapetonReportExport.h"

#include <optional>
#include <string>

namespace shapeton
{
/** Bytes as base64 with padding and without line breaks (RFC 4648). \ingroup ShapetonReport */
ShapetonReport_EXPORT std::string
                      Base64(const std::string & bytes);

/** The bytes of a text written by Base64(); empty if it is malformed. \ingroup ShapetonReport */
ShapetonReport_EXPORT std::optional<std::string>
                      BytesOfBase64(const std::string & text);

/** Whether these bytes begin like a PNG file. \ingroup ShapetonReport */
ShapetonReport_EXPORT bool
IsPng(const std::string & bytes);
} // namespace shapeton

#endif
