#ifndef shapetonJson_h
#define shapetonJson_h

#include "ShapetonReportExport.h"
#include "shapetonJsonForward.h"
#include "shapetonProvenance.h"

#include <nlohmann/json.hpp>

#include <string>

namespace shapeton
{
/** Writes a document, indented by two spaces, with a final newline. Malformed UTF-8 becomes U+FFFD; a non-finite number
 * becomes null. Throws OutputError.
 * \ingroup ShapetonReport */
ShapetonReport_EXPORT void
WriteJson(const Json & document, const std::string & path);

/** Reads a document. Throws InputError with the file and either the line and column of the error or the key that occurs
 * twice in an object.
 * \ingroup ShapetonReport */
ShapetonReport_EXPORT Json
ReadJson(const std::string & path);

/** An object with a key for each name; the last of duplicate names is used.
 * \ingroup ShapetonReport */
ShapetonReport_EXPORT Json
ProvenanceToJson(const Provenance & provenance);

/** A measured value for a document: rounded to `digits` significant digits, null if it is not finite.
 * \ingroup ShapetonReport */
ShapetonReport_EXPORT Json
RoundedJson(double value, int digits = 6);

/** "line 3, column 14": the position of byte number `byte` of the text, counted from 1.
 * \ingroup ShapetonReport */
ShapetonReport_EXPORT std::string
                      PlaceInText(const std::string & text, std::size_t byte);
} // namespace shapeton

#endif
