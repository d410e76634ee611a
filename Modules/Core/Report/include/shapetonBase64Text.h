#ifndef shapetonBase64Text_h
#define shapetonBase64Text_h

#include "ShapetonReportExport.h"

#include <string>

namespace shapeton
{
/** Bytes as base64 with padding and without line breaks (RFC 4648). \ingroup ShapetonReport */
ShapetonReport_EXPORT std::string
                      Base64(const std::string & bytes);
} // namespace shapeton

#endif
