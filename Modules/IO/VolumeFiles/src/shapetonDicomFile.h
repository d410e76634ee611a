#ifndef shapetonDicomFile_h
#define shapetonDicomFile_h

#include "shapetonByteStream.h"
#include "shapetonDicomSeriesScan.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** Header data of one frame of a DICOM file. */
struct DicomFrame
{
  bool   hasGeometry{ false };
  double position[3]{};
  /** Direction cosines along a row, then along a column. */
  double orientation[6]{};
  /** Distance between rows, distance between columns. */
  double           spacing[2]{};
  double           thickness{ 0 };
  bool             isLocalizer{ false };
  DicomPixelFormat pixels;

  /** Attributes that are usually constant in a volume and distinguish acquisitions or reconstructions with interleaved
   * or equal positions. */
  static constexpr unsigned int NumberOfAcquisitionKeys = 20;
  /** Their values, in the order of their names. */
  std::string acquisition[NumberOfAcquisitionKeys];
  static std::string
  NameOfAcquisitionKey(unsigned int key);
};

/** Header data of a file. */
struct DicomFile
{
  enum class Kind : std::uint8_t
  {
    notDicom,
    notImage,
    /** Truncated before its series UID. */
    damaged,
    image
  };

  std::string path;
  Kind        kind{ Kind::notDicom };
  /** notImage: the kind of object. damaged: the defect. */
  std::string what;

  std::string studyUID;
  std::string sopClassUID;
  std::string sopInstanceUID;
  std::string seriesUID;
  std::string frameOfReferenceUID;
  std::string patientID;
  std::string studyDate;
  std::string description;
  /** The bytes of the description are invalid in its character set. */
  bool        isUndecodable{ false };
  std::string modality;
  std::string patientPosition;
  std::string transferSyntax;
  int         seriesNumber{ 0 };
  int         instanceNumber{ 0 };

  std::uint16_t rows{ 0 };
  std::uint16_t columns{ 0 };
  bool          isLossy{ false };
  /** Computed from other images, according to Image Type. */
  bool isDerived{ false };
  bool isInverted{ false };
  /** The image has functional groups, so its frames are slices. */
  bool isMultiFrame{ false };
  /** Tiles in a row of a Siemens mosaic, whose tiles are the frames; 1 for other images. */
  unsigned int tilesPerRow{ 1 };
  /** Further frames of a multi-frame image without positions. */
  unsigned int unplacedFrames{ 0 };
  /** The pixel encoding is not supported. */
  bool isUnsupportedTransferSyntax{ false };
  /** Description of missing data; empty for a complete file. */
  std::string truncation;
  /** Attribute and value of an unreadable number in its geometry or intensities. The file then has no frames. */
  std::string malformedValue;
  /** Reason why its pixels are not a slice of a volume: color, 2-D, ... */
  std::string refusal;
  /** The file was rejected because it is another kind of image, not because a slice of a volume is damaged. */
  bool isOtherObject{ false };

  std::vector<DicomFrame> frames;
};

/** Parses the header of a file with DCMTK. Runs in a contained process. */
DicomFile
ParseDicomFile(const std::string & path);

/** Writes or reads all members of a file except its path. */
template <typename TStream, typename TFile>
void
Transmit(TStream & stream, TFile & file)
{
  stream & file.kind & file.what & file.studyUID & file.sopClassUID & file.sopInstanceUID & file.seriesUID & file
    .frameOfReferenceUID & file.patientID & file.studyDate & file.description & file.isUndecodable & file
    .modality & file.patientPosition & file.transferSyntax & file.seriesNumber & file.instanceNumber & file.rows & file
    .columns & file.isLossy & file.isDerived & file.isInverted & file.isMultiFrame & file.tilesPerRow & file
    .unplacedFrames & file.isUnsupportedTransferSyntax & file.truncation & file.malformedValue & file.refusal & file
    .isOtherObject;
  stream.SizeOf(file.frames);
  for (auto & frame : file.frames)
  {
    auto &   pixels = frame.pixels;
    stream & frame.hasGeometry & frame.position & frame.orientation & frame.spacing & frame.thickness & frame
      .isLocalizer & frame.acquisition & pixels.bitsAllocated & pixels.bitsStored & pixels.highBit & pixels
      .isSigned & pixels.hasRescale & pixels.slope & pixels.intercept & pixels.hasPadding & pixels.paddingLow & pixels
      .paddingHigh;
  }
}
} // namespace shapeton

#endif
