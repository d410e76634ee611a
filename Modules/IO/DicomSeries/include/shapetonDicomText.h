#ifndef shapetonDicomText_h
#define shapetonDicomText_h

#include "DicomSeriesExport.h"

#include <string>
#include <vector>

namespace shapeton
{
/** \defgroup DicomText Values as DICOM writes them
 * \ingroup DicomSeries */
///@{

/** A Decimal String: at most 16 characters, as many digits as fit. Throws InputError for what is no finite number. */
DicomSeries_EXPORT std::string
                   DicomDecimal(double value);

/** "a\b\c": several values of one attribute. */
DicomSeries_EXPORT std::string
                   JoinDicomValues(const std::vector<std::string> & values);

/** The values of "a\b\c" without blanks around them; none for a text without any. */
DicomSeries_EXPORT std::vector<std::string>
                   SplitDicomValues(const std::string & text);

/** Texts in one, each with its length before it, so that no two lists give the same: for MakeDicomUID(). */
DicomSeries_EXPORT std::string
                   ConcatenateTexts(const std::vector<std::string> & texts);

/** "2.25." and a UUID in decimal digits (DICOM PS3.5 B.2), the UUID a custom one (RFC 9562, version 8) from the SHA-256
 * of the text: equal texts, equal UIDs. */
DicomSeries_EXPORT std::string
                   MakeDicomUID(const std::string & text);
///@}
} // namespace shapeton

#endif
