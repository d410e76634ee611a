#ifndef shapetonDicomVolume_h
#define shapetonDicomVolume_h

#include "shapetonDicomSeriesScan.h"
#include "shapetonVolumeReader.h"

namespace shapeton
{
/** The grid of the repair `deshear`, which covers all displaced slices. */
struct DeshearedPlane
{
  /** Position of the first column and row, in mm relative to the first slice of the series. */
  double start[2];
  /** Columns and rows. */
  std::size_t size[2];
  /** Pixels of the plane per pixel of a slice. */
  double growth;
};

DeshearedPlane
PlaneOfSlices(const DicomSeries & series, const std::vector<DicomSlice> & slices);

/** Sets the fields of shapetonDicomFields.h in the dictionary of the image. */
void
SetDicomFields(Volume & volume);

/** Reads the pixels of a series and applies the requested and necessary repairs. The series must not have other
 * defects. Throws InputError. */
Volume
ReadDicomVolume(const DicomSeries & series, const VolumeReadOptions & options, const Progress & progress);
} // namespace shapeton

#endif
