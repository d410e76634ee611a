#ifndef shapetonDicomAttributes_h
#define shapetonDicomAttributes_h

#include "DicomSeriesExport.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

class DcmFileFormat;
class DcmItem;
class DcmTagKey;

namespace shapeton
{
/** \defgroup DicomAttributes Attributes of DICOM files of any maker, parsed by DCMTK
 * The files are untrusted: these functions are called in a ContainedProcess.
 * \ingroup DicomSeries */
///@{

/** Configures DCMTK for a contained process: no log, and attributes of the data dictionary that are stored with VR UN
 * are decoded, in data sets and in sequences. Their values are implicit VR little endian in every transfer syntax
 * (PS3.5 6.2.2). */
DicomSeries_EXPORT void
PrepareDicomParsing();

/** A value that breaks the rules of its attribute; the message names attribute and value. */
class MalformedDicomValue : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** The numbers of an attribute; empty where it is missing or has no value. Throws MalformedDicomValue where one of them
 * is not a finite decimal number, or where there are not `count` of them. */
DicomSeries_EXPORT std::vector<double>
                   DicomNumbersOf(DcmItem & item, const DcmTagKey & tag, std::size_t count);

/** A text in UTF-8: one line of at most 256 bytes. */
struct DicomText
{
  std::string text;
  /** The bytes are valid in the Specific Character Set of the item or of those around it; if not, '?' replaces what is
   * not UTF-8. */
  bool isDecoded{ true };
};

/** The text of an attribute, empty where it is missing. Besides what DcmSpecificCharacterSet accepts: a single term
 * with code extensions ("ISO 2022 IR 100"), bytes of a declared set without its escape sequence, ISO_IR 203, and the
 * Japanese sets 87 and 159 where iconv has no converter for them (glibc). */
DicomSeries_EXPORT DicomText
DicomTextOf(DcmItem & item, const DcmTagKey & tag);

/** The transfer syntax of a file. */
struct DicomEncoding
{
  /** Its name, or its UID where the name is not known. */
  std::string name;
  /** The data set is parsed correctly and its pixels can be decoded. */
  bool isSupported{ false };
  /** DCMTK does not know the transfer syntax: what it has parsed may be wrong. */
  bool isUnknown{ false };
};

DicomSeries_EXPORT DicomEncoding
DicomEncodingOf(DcmFileFormat & file);

/** Label Map Segmentation Storage (Supplement 243), which DCMTK 3.6.7 does not know. */
constexpr const char * LabelMapSegmentationStorageUID = "1.2.840.10008.5.1.4.1.1.66.7";
///@}
} // namespace shapeton

#endif
