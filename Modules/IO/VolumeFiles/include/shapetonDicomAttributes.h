#ifndef shapetonDicomAttributes_h
#define shapetonDicomAttributes_h

#include "ShapetonVolumeFilesExport.h"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

class DcmFileFormat;
class DcmItem;
class DcmTagKey;

namespace shapeton
{
/** \defgroup DicomAttributes Attributes of DICOM files from any vendor, parsed by DCMTK
 * The files are untrusted; call these functions in a ContainedProcess.
 * \ingroup ShapetonVolumeFiles */
///@{

/** Configures DCMTK for a contained process: no log, and known attributes stored with VR UN are decoded, in data sets
 * and in sequences. The values of such attributes are implicit VR little endian in every transfer syntax (PS3.5 6.2.2).
 * Throws std::runtime_error if the data dictionary is missing. */
ShapetonVolumeFiles_EXPORT void
PrepareDicomParsing();

/** A value that violates the rules of its attribute; the message contains attribute and value. */
class MalformedDicomValue : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** The numbers of an attribute; empty if it is missing or empty. Throws MalformedDicomValue unless they are `count`
 * finite decimal numbers. */
ShapetonVolumeFiles_EXPORT std::vector<double>
                           DicomNumbersOf(DcmItem & item, const DcmTagKey & tag, std::size_t count);

/** Text in UTF-8: one line of at most 256 bytes. */
struct DicomText
{
  std::string text;
  /** Whether the bytes are valid in the Specific Character Set of the item or its parents; if not, '?' replaces
   * malformed UTF-8. */
  bool isDecoded{ true };
};

/** The text of an attribute; empty if it is missing. In addition to DcmSpecificCharacterSet it accepts a single term
 * with code extensions ("ISO 2022 IR 100"), bytes of a declared set without its escape sequence, ISO_IR 203, and
 * the Japanese sets 87 and 159 if iconv has no converter for them (glibc). */
ShapetonVolumeFiles_EXPORT DicomText
DicomTextOf(DcmItem & item, const DcmTagKey & tag);

/** The transfer syntax of a file. */
struct DicomEncoding
{
  /** Its name, or its UID if the name is unknown. */
  std::string name;
  /** The data set is parsed correctly and the pixels can be decoded. */
  bool isSupported{ false };
  /** The transfer syntax is unknown to DCMTK; the parsed data set may be wrong. */
  bool isUnknown{ false };
  /** Deflated Image Frame Compression (Supplement 244). */
  bool hasDeflatedFrames{ false };
  bool isJpeg2000{ false };
};

ShapetonVolumeFiles_EXPORT DicomEncoding
DicomEncodingOf(DcmFileFormat & file);

/** Loads a file; values of more than `maximumEagerValue` bytes stay on disk until they are accessed. Also parses
 * Deflated Image Frame Compression and High-Throughput JPEG 2000, which DCMTK 3.6.7 does not know; the data set then
 * states RLE or JPEG 2000 as its transfer syntax, and DicomEncodingOf() states the true one. Returns a description of
 * the fault; empty if there is none. */
ShapetonVolumeFiles_EXPORT std::string
LoadDicomFile(DcmFileFormat & file, const std::string & path, unsigned int maximumEagerValue);

/** Decodes a frame (counted from 0) of a loaded file into exactly `bytes` bytes. Frames of single bits must be deflated
 * or in JPEG 2000; they are packed, the first pixel in the lowest bit. Returns the bits of a decoded pixel, or 0 if
 * they are defined by the header: JPEG 2000 streams encode numbers, sometimes with more bits than Bits Stored; other
 * encodings store words. Throws std::runtime_error. */
ShapetonVolumeFiles_EXPORT std::uint16_t
                           DecodeDicomFrame(DcmFileFormat & file, unsigned int frame, std::size_t bytes, char * pixels);

/** Label Map Segmentation Storage (Supplement 243), missing in DCMTK 3.6.7. */
constexpr const char * LabelMapSegmentationStorageUID = "1.2.840.10008.5.1.4.1.1.66.7";
///@}
} // namespace shapeton

#endif
