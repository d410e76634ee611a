#ifndef shapetonDicomText_h
#define shapetonDicomText_h

#include "ShapetonVolumeFilesExport.h"

#include <string>
#include <vector>

namespace shapeton
{
/** \defgroup DicomText Formatting of DICOM values
 * \ingroup ShapetonVolumeFiles */
///@{

/** A Decimal String: at most 16 characters, as many digits as fit. Throws InputError for a nonfinite number. */
ShapetonVolumeFiles_EXPORT std::string
                           DicomDecimal(double value);

/** "a\b\c": several values of one attribute. */
ShapetonVolumeFiles_EXPORT std::string
                           JoinDicomValues(const std::vector<std::string> & values);

/** The values in "a\b\c", without surrounding blanks; an empty list for an empty string. */
ShapetonVolumeFiles_EXPORT std::vector<std::string>
                           SplitDicomValues(const std::string & text);

/** Concatenates strings, each preceded by its length, as an injective input for MakeDicomUID(). */
ShapetonVolumeFiles_EXPORT std::string
                           ConcatenateTexts(const std::vector<std::string> & texts);

/** "2.25." and a UUID in decimal digits (DICOM PS3.5 B.2). The custom UUID (RFC 9562, version 8) is computed from the
 * SHA-256 of the text, so equal texts yield equal UIDs. */
ShapetonVolumeFiles_EXPORT std::string
                           MakeDicomUID(const std::string & text);
///@}
} // namespace shapeton

#endif
