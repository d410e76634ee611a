#ifndef shapetonDicomSeriesScan_h
#define shapetonDicomSeriesScan_h

#include "DicomSeriesExport.h"

#include "shapetonProgress.h"

#include "itkMatrix.h"
#include "itkPoint.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace shapeton
{
/** \brief What can be wrong with the files of a DICOM folder. The names are fixed; programmes may rely on them.
 * \ingroup DicomSeries */
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
  /** The slices are displaced within their plane: gantry tilt. */
  shear,
  /** A planning image (Image Type says LOCALIZER), no part of a volume. */
  localizer,
  /** One Series Instance UID with images that do not form one volume. */
  mixedSeries,
  /** A file ends before its content does. */
  truncated,
  /** Pixels in an encoding that cannot be read (video, JPIP, ...). */
  unsupportedTransferSyntax,
  /** A file without a slice image: text, report, structure set, DICOMDIR, ... */
  notAnImage,
  /** The slices of one volume name several frames of reference, a flaw of some de-identifications: a remark. */
  mixedFrameOfReference,
  /** The slices of one volume name several patients (Patient ID), another such flaw: a remark. */
  mixedPatient,
  /** A number of the geometry or the intensities cannot be read, for example for its decimal comma. */
  malformedValue,
  /** A text whose bytes do not fit its character set: a remark. */
  undecodableText
};

/** The fixed name, for example "duplicateIdentical".
 * \ingroup DicomSeries */
DicomSeries_EXPORT const char *
GetDicomDefectName(DicomDefectKind kind);

/** \brief One defect, in a sentence, with the files and slices concerned.
 * \ingroup DicomSeries */
struct DicomDefect
{
  DicomDefectKind kind;
  std::string     message;
  /** Files concerned, in the order of position, then of name. */
  std::vector<std::string> files;
  /** Slices concerned, numbered from 1 along the normal; empty for defects of files. */
  std::vector<unsigned int> slices;
  /** False for gaps and shear beyond what ReadVolume() repairs: the grid would be several times the slices. */
  bool isRepairable{ true };
};

/** What a person can do about a defect, for example the option of the tools that repairs it.
 * \ingroup DicomSeries */
DicomSeries_EXPORT const char *
GetDicomDefectAdvice(const DicomDefect & defect);

/** \brief How the stored pixels of a slice become intensities: value = slope * stored + intercept.
 * \ingroup DicomSeries */
struct DicomPixelFormat
{
  std::uint16_t bitsAllocated{ 16 };
  std::uint16_t bitsStored{ 16 };
  std::uint16_t highBit{ 15 };
  bool          isSigned{ false };
  double        slope{ 1.0 };
  double        intercept{ 0.0 };
  /** The header has a slope or an intercept. Slices with and without are in different units: a mixed series. */
  bool hasRescale{ false };
  /** Stored values in [paddingLow, paddingHigh] are no measurement (Pixel Padding Value). */
  bool         hasPadding{ false };
  std::int64_t paddingLow{ 0 };
  std::int64_t paddingHigh{ 0 };
};

/** \brief One slice: a file, or a frame of a multi-frame file.
 * \ingroup DicomSeries */
struct DicomSlice
{
  std::string file;
  /** Frame of the file, from 0. */
  unsigned int frame{ 0 };
  /** The file has frames, be it one: who refers to the slice names its frame. */
  bool isMultiFrame{ false };
  /** By which other objects refer to the file. */
  std::string sopClassUID;
  std::string sopInstanceUID;
  int         instanceNumber{ 0 };
  /** Image Position (Patient) of the first pixel, LPS mm. */
  itk::Point<double, 3> imagePosition{};
  /** Distance from the first slice along the normal, mm. */
  double position{ 0.0 };
  /** Displacement against the first slice along rows and columns, mm; 0 unless the series is sheared. */
  double offset[2]{ 0.0, 0.0 };
  /** Slice Thickness, mm; 0 when not stated. Used for the spacing of a single slice and for nothing else. */
  double           thickness{ 0.0 };
  DicomPixelFormat pixels;
};

/** \brief Images of one Series Instance UID that share orientation, size, pixel spacing and acquisition.
 * \ingroup DicomSeries */
struct DicomSeries
{
  std::string uid;
  std::string studyUID;
  /** Of the first slice. */
  std::string frameOfReferenceUID;
  /** 1 of 1, unless the series is mixed: then its parts are numbered and chosen as "UID#1", "UID#2". */
  unsigned int part{ 1 };
  unsigned int parts{ 1 };
  int          number{ 0 };
  std::string  description;
  /** What tells this part from the others, for example "ConvolutionKernel B70f"; empty where its geometry does. */
  std::string distinction;
  std::string modality;
  std::string patientPosition;
  /** Names of the transfer syntaxes, joined by ", ". */
  std::string transferSyntax;
  /** Columns, rows, slices. */
  unsigned int size[3]{ 0, 0, 0 };
  /** Distance of columns, of rows, of slices along the normal, mm. The last one is the usual distance (median) where
   * the series is irregular, and 0 for a single slice. */
  double spacing[3]{ 0.0, 0.0, 0.0 };
  /** Columns: along a row, along a column, normal. */
  itk::Matrix<double, 3, 3> direction{};
  /** Pixels went through a lossy compression. */
  bool isLossy{ false };
  /** MONOCHROME1: low values are shown bright. The values themselves are not affected. */
  bool isInverted{ false };
  /** In ascending order along the normal. */
  std::vector<DicomSlice>  slices;
  std::vector<DicomDefect> defects;
  /** What is unusual and keeps nobody from reading the volume. */
  std::vector<DicomDefect> remarks;
  /** Why this is no volume, when no defect says it: colour, 2-D image, a single slice, ... Empty otherwise. */
  std::string refusal;
  /** The slices are sound but there is only one. */
  bool isSingleSlice{ false };

  /** Text that chooses this series: the UID, with "#part" for a part of a mixed series. */
  DicomSeries_EXPORT std::string
                     GetSelector() const;
  /** True when a volume can be read without a repair. */
  bool
  IsUsable() const
  {
    return defects.empty() && refusal.empty();
  }
  DicomSeries_EXPORT bool
  Has(DicomDefectKind kind) const;
};

/** \brief What a folder holds.
 * \ingroup DicomSeries */
struct DicomScan
{
  std::string path;
  /** Number of files looked at. */
  unsigned int files{ 0 };
  /** In the order of series number, UID and part. */
  std::vector<DicomSeries> series;
  /** Files outside any series: not DICOM, DICOM without an image, too damaged to tell. */
  std::vector<DicomDefect> otherFiles;
  /** How many DICOM objects without an image there are of each kind, for example "RTStructureSetStorage". */
  std::map<std::string, unsigned int> otherObjects;
};

/** \brief Lists the DICOM series in a folder (searched recursively; each file and folder once, symbolic links followed)
 * or in one file. Reads headers only, except of slices at equal positions, whose pixels are compared.
 *
 * Grouping: by Series Instance UID, Patient ID, Patient Position, frame of reference, orientation, size and pixel
 * spacing. Groups of one study that differ in patient or frame of reference alone are one volume with the remark
 * mixedPatient or mixedFrameOfReference where their slices, three or more, are equidistant together. Then by
 * an attribute of acquisition or reconstruction (acquisition number, temporal position, echo, b-value, stack, image
 * type, kernel, filter, diameter, thickness, kVp, series description and others), where several such groups, each a
 * grid on its own, cover the same positions or interleave: then each is coarser than the whole. Slices are ordered by
 * Image Position (Patient) along the normal of Image Orientation (Patient); Slice Thickness, Spacing Between Slices,
 * Slice Location and Instance Number are not used.
 *
 * Tolerances. Direction cosines: 1e-4. Pixel spacing: relative 1e-4. Positions along the normal and within the plane:
 * 1 % of the slice distance (of the pixel spacing), at least 0.01 mm, where that is at most 10 % of the distance; real
 * series jitter by micrometres. Distances below 0.001 mm are no distance.
 *
 * Throws InputError when the path does not exist, cannot be read, or is an empty folder.
 * \ingroup DicomSeries */
DicomSeries_EXPORT DicomScan
ScanDicom(const std::string & path, const Progress & progress = {});
} // namespace shapeton

#endif
