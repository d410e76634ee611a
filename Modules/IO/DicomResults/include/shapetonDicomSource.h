#ifndef shapetonDicomSource_h
#define shapetonDicomSource_h

#include "ShapetonDicomResultsExport.h"
#include "shapetonVolumeReader.h"

#include "itkImageBase.h"

#include <string>

namespace shapeton
{
/** The source series of results. Results share its patient, study and frame of reference, and reference its slices.
 * \ingroup ShapetonDicomResults */
struct DicomSource
{
  DicomSeries series;
  /** The grid of its voxels: size, spacing, origin, direction. */
  itk::ImageBase<3>::Pointer grid;
  /** Attributes that results copy from the header of the first slice, as a data set in explicit VR little endian:
   * patient, study, character set, time zone, clinical trial, de-identification, dates. */
  std::string header;
};

/** The source series of a result, and its requirements. \ingroup ShapetonDicomResults */
struct DicomSourceOptions
{
  /** As in VolumeReadOptions. */
  std::string seriesUID;
  /** Accept a tilted series; the grid is then that of the repair `deshear`. For reading only. */
  bool deshear{ false };
  /** Whether messages on a tilted series may suggest `deshear`. */
  bool offersDeshear{ false };
  /** Accept an irregular series, a single slice, or a series without a frame of reference: pixel positions require only
   * the position of their slice. For reading only. */
  bool forPoints{ false };
};

/** Reads the headers of a series, which must be regular because results cannot reference the slices of a repaired
 * volume. Throws InputError as ReadVolume() does, and if slices have no SOP Instance UID. \ingroup ShapetonDicomResults
 */
ShapetonDicomResults_EXPORT DicomSource
ReadDicomSource(const std::string & path, const DicomSourceOptions & options = {});

/** Description of a result for its header. \ingroup ShapetonDicomResults */
struct DicomResultHeader
{
  /** The program that created it. */
  std::string tool;
  std::string version;
  int         seriesNumber{ 0 };
  /** At most 64 characters. */
  std::string seriesDescription;
};

/** Reference to a result from other objects. \ingroup ShapetonDicomResults */
struct DicomInstance
{
  std::string sopClassUID;
  std::string sopInstanceUID;
  std::string seriesUID;
};

/** Statement in each result that it is for research use, not for diagnosis. \ingroup ShapetonDicomResults */
constexpr const char * DicomResearchNote = "For research use; not a diagnosis.";
} // namespace shapeton

#endif
