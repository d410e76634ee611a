#ifndef shapetonDicomSeriesScan_h
#define shapetonDicomSeriesScan_h

#include "ShapetonVolumeFilesExport.h"

#include "shapetonProgress.h"

#include "itkMatrix.h"
#include "itkPoint.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace shapeton
{
/** \brief Defects of the files of a DICOM folder. The names are stable, so programs may rely on them.
 * \ingroup ShapetonVolumeFiles */
enum class DicomDefectKind
{
  /** Several slices at one position with equal intensities. */
  duplicateIdentical,
  /** Several slices at one position with different intensities. */
  duplicateConflicting,
  /** Slices are missing: a distance is a multiple of the others. */
  gap,
  /** The distance between slices changes. */
  variableSpacing,
  /** The slices are displaced within their planes (gantry tilt). */
  shear,
  /** A planning image (Image Type contains LOCALIZER), not part of a volume. */
  localizer,
  /** One Series Instance UID contains images that do not form one volume. */
  mixedSeries,
  /** A file ends prematurely. */
  truncated,
  /** Pixels in an unsupported encoding (video, JPIP, ...). */
  unsupportedTransferSyntax,
  /** A file without a slice image: text, report, structure set, DICOMDIR, ... */
  notAnImage,
  /** The slices of one volume have several frames of reference, an error made by some de-identification tools; a
   * remark. */
  mixedFrameOfReference,
  /** The slices of one volume have several patients (Patient ID), another error made by such tools; a remark. */
  mixedPatient,
  /** A number of the geometry or the intensities cannot be parsed, for example because of a decimal comma. */
  malformedValue,
  /** Text that is invalid in its character set; a remark. */
  undecodableText,
  /** Files with the same bytes as another one, which is used; a remark. */
  copiedFile
};

/** The stable name, for example "duplicateIdentical".
 * \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT const char *
GetDicomDefectName(DicomDefectKind kind);

/** \brief One defect: a message, and the files and slices concerned.
 * \ingroup ShapetonVolumeFiles */
struct DicomDefect
{
  DicomDefectKind kind;
  std::string     message;
  /** Affected files, ordered by position, then by name. */
  std::vector<std::string> files;
  /** Affected slices, numbered from 1 along the normal; empty for defects of files. */
  std::vector<unsigned int> slices;
  /** False for gaps and shear that ReadVolume() does not repair because the grid would have several times as many
   * slices. */
  bool isRepairable{ true };
};

/** Repairs that messages on defects may suggest. \ingroup ShapetonVolumeFiles */
enum class DicomRepairAdvice
{
  None,
  Deshear,
  AllRepairs
};

/** Advice on a defect, for example the option of the tools that repairs it.
 * \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT const char *
GetDicomDefectAdvice(const DicomDefect & defect);

/** \brief Conversion of the stored pixels of a slice to intensities: value = slope * stored + intercept.
 * \ingroup ShapetonVolumeFiles */
struct DicomPixelFormat
{
  std::uint16_t bitsAllocated{ 16 };
  std::uint16_t bitsStored{ 16 };
  std::uint16_t highBit{ 15 };
  bool          isSigned{ false };
  double        slope{ 1.0 };
  double        intercept{ 0.0 };
  /** The header has a slope or an intercept. A series that mixes slices with and without them has different units. */
  bool hasRescale{ false };
  /** Stored values in [paddingLow, paddingHigh] are padding (Pixel Padding Value). */
  bool         hasPadding{ false };
  std::int64_t paddingLow{ 0 };
  std::int64_t paddingHigh{ 0 };
};

/** \brief One slice: a file, or a frame of a multi-frame file.
 * \ingroup ShapetonVolumeFiles */
struct DicomSlice
{
  std::string file;
  /** Frame of the file, counted from 0. */
  unsigned int frame{ 0 };
  /** The file is multi-frame, possibly with a single frame: references to the slice include the frame number. */
  bool isMultiFrame{ false };
  /** More than 1 for a Siemens mosaic, a single image of which `frame` is a tile. */
  unsigned int tilesPerRow{ 1 };
  /** UIDs by which other objects reference the file. */
  std::string sopClassUID;
  std::string sopInstanceUID;
  int         instanceNumber{ 0 };
  /** Image Position (Patient) of the first pixel, LPS mm. */
  itk::Point<double, 3> imagePosition{};
  /** Distance from the first slice along the normal, mm. */
  double position{ 0.0 };
  /** Displacement relative to the first slice along rows and columns, mm; 0 unless the series is sheared. */
  double offset[2]{ 0.0, 0.0 };
  /** Slice Thickness, mm; 0 if missing. */
  double           thickness{ 0.0 };
  DicomPixelFormat pixels;
};

/** \brief Images of one Series Instance UID that share orientation, size, pixel spacing and acquisition.
 * \ingroup ShapetonVolumeFiles */
struct DicomSeries
{
  std::string uid;
  std::string studyUID;
  /** Frame of reference of the first slice. */
  std::string frameOfReferenceUID;
  /** Part number and number of parts; 1 of 1 unless the series is mixed: then parts are selected as "UID#1",
   * "UID#2". */
  unsigned int part{ 1 };
  unsigned int parts{ 1 };
  int          number{ 0 };
  std::string  description;
  /** Distinguishing attribute of this part, for example "ConvolutionKernel B70f"; empty if parts differ in geometry. */
  std::string distinction;
  std::string modality;
  /** Patient ID and Study Date of the first slice, which identify a person. */
  std::string patientID;
  std::string studyDate; ///< as YYYYMMDD
  std::string patientPosition;
  /** Names of the transfer syntaxes, joined by ", ". */
  std::string transferSyntax;
  /** Columns, rows, slices. */
  unsigned int size[3]{ 0, 0, 0 };
  /** Spacing of columns, rows, and slices along the normal, mm. The slice spacing of an irregular series is the median;
   * 0 for a single slice. */
  double spacing[3]{ 0.0, 0.0, 0.0 };
  /** Columns: along a row, along a column, normal. */
  itk::Matrix<double, 3, 3> direction{};
  /** The pixels were compressed lossily. */
  bool isLossy{ false };
  /** The images were computed from others (Image Type DERIVED). */
  bool isDerived{ false };
  /** MONOCHROME1: low values are displayed bright. The values are not affected. */
  bool isInverted{ false };
  /** Ascending along the normal. */
  std::vector<DicomSlice>  slices;
  std::vector<DicomDefect> defects;
  /** Irregularities that do not prevent reading the volume. */
  std::vector<DicomDefect> remarks;
  /** Reason why the series is not a volume, if not a defect: color, 2-D image, a single slice, ... Empty otherwise. */
  std::string refusal;
  /** There is a single, valid slice. */
  bool isSingleSlice{ false };

  /** Selector of this series: the UID, with "#part" for a part of a mixed series. */
  ShapetonVolumeFiles_EXPORT std::string
                             GetSelector() const;
  /** True if a volume can be read without repair. */
  bool
  IsUsable() const
  {
    return defects.empty() && refusal.empty();
  }
  ShapetonVolumeFiles_EXPORT bool
  Has(DicomDefectKind kind) const;
};

/** \brief Contents of a folder.
 * \ingroup ShapetonVolumeFiles */
struct DicomScan
{
  std::string path;
  /** Number of files examined. */
  unsigned int files{ 0 };
  /** Ordered by series number, UID and part. */
  std::vector<DicomSeries> series;
  /** Files outside any series: not DICOM, DICOM without an image, or too damaged to identify. */
  std::vector<DicomDefect> otherFiles;
  /** Number of DICOM objects of each kind that have no image, for example "RTStructureSetStorage". */
  std::map<std::string, unsigned int> otherObjects;
};

/** \brief Lists the DICOM series in a folder (searched recursively; each file and folder once, following symbolic
 * links) or in one file. Reads only headers, except for slices at equal positions, whose pixels are compared.
 *
 * Files with the same SOP Instance UID and the same bytes are used once, the first in the order of their names.
 *
 * Grouping: by Series Instance UID, Patient ID, Patient Position, frame of reference, orientation, size and pixel
 * spacing. Groups of one study that differ only in patient or frame of reference form one volume if they have three or
 * more slices in total and these are equidistant. The volume gets the remark mixedPatient or mixedFrameOfReference. A
 * group is then split by an attribute of acquisition or reconstruction (acquisition number, temporal position, echo,
 * b-value, stack, image type, kernel, filter, diameter, thickness, kVp, series description and others), if several of
 * the resulting groups are regular grids that cover the same positions or interleave, that is, each is coarser than
 * their union. Slices are ordered by Image Position (Patient) along the normal of Image Orientation (Patient); Slice
 * Thickness, Spacing Between Slices, Slice Location and Instance Number are not used.
 *
 * Tolerances: Direction cosines: 1e-4. Pixel spacing: relative 1e-4. Positions along the normal and within the plane: 1
 * % of the slice distance or of the pixel spacing, respectively, but at least 0.01 mm if that is at most 10 % of the
 * distance; real series jitter by micrometers. Distances below 0.001 mm count as 0.
 *
 * Throws InputError if the path does not exist, cannot be read, or is an empty folder.
 * \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT DicomScan
ScanDicom(const std::string & path, const Progress & progress = {});
} // namespace shapeton

#endif
