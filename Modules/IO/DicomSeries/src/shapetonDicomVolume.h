#ifndef shapetonDicomVolume_h
#define shapetonDicomVolume_h

#include "shapetonDicomSeriesScan.h"
#include "shapetonVolumeReader.h"

namespace shapeton
{
/** Where slices that are displaced within their planes lie on the grid that covers all of them, the grid of the repair
 * `deshear`. */
struct DeshearedPlane
{
  /** The first column and row, mm from those of the first slice of the series. */
  double start[2];
  /** Columns and rows. */
  std::size_t size[2];
  /** Pixels of the plane for each pixel of a slice. */
  double growth;
};

DeshearedPlane
PlaneOfSlices(const DicomSeries & series, const std::vector<DicomSlice> & slices);

/** Reads the pixels of a series and makes the repairs that the options ask for and the series needs. The series must
 * have no other defect. Throws InputError. */
Volume
ReadDicomVolume(const DicomSeries & series, const VolumeReadOptions & options);
} // namespace shapeton

#endif
