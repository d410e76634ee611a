#ifndef shapetonDicomSource_h
#define shapetonDicomSource_h

#include "DicomResultsExport.h"
#include "shapetonVolumeReader.h"

#include "itkImageBase.h"

#include <string>

namespace shapeton
{
/** The series that results were made from. They belong to its patient, study and frame of reference, and refer to its
 * slices. \ingroup DicomResults */
struct DicomSource
{
  DicomSeries series;
  /** The grid of its voxels: size, spacing, origin, direction. */
  itk::ImageBase<3>::Pointer grid;
  /** What results take over of the header of the first slice, as a data set in explicit VR little endian: patient,
   * study, character set, time zone, clinical trial, de-identification, dates. */
  std::string header;
};

/** Which series a result belongs to, and what it must have. \ingroup DicomResults */
struct DicomSourceOptions
{
  /** As VolumeReadOptions has it. */
  std::string seriesUID;
  /** Take a tilted series: the grid is then that of the repair `deshear`. For reading alone. */
  bool deshear{ false };
  /** A message on a tilted series may advise `deshear`. */
  bool offersDeshear{ false };
  /** An irregular series, a single slice, or one without a frame of reference is enough: points in pixels need the
   * place of their slice alone. For reading alone. */
  bool forPoints{ false };
};

/** Reads the headers of a series. It must be a regular one: a slice of a repaired volume would have nothing to refer
 * to. Throws InputError as ReadVolume() does, and where slices have no SOP Instance UID. \ingroup DicomResults */
DicomResults_EXPORT DicomSource
ReadDicomSource(const std::string & path, const DicomSourceOptions & options = {});

/** How a result names itself. \ingroup DicomResults */
struct DicomResultHeader
{
  /** The program that made it. */
  std::string tool;
  std::string version;
  int         seriesNumber{ 0 };
  /** At most 64 characters. */
  std::string seriesDescription;
};

/** By which other objects refer to a result. \ingroup DicomResults */
struct DicomInstance
{
  std::string sopClassUID;
  std::string sopInstanceUID;
  std::string seriesUID;
};

/** What each result says of itself: for research use, no diagnosis. \ingroup DicomResults */
constexpr const char * DicomResearchNote = "For research use; not a diagnosis.";
} // namespace shapeton

#endif
