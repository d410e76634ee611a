#ifndef shapetonDicomVolume_h
#define shapetonDicomVolume_h

#include "shapetonDicomSeriesScan.h"
#include "shapetonVolumeReader.h"

namespace shapeton
{
/** Reads the pixels of a series and makes the repairs that the options ask for and the series needs. The series must
 * have no other defect. Throws InputError. */
Volume
ReadDicomVolume(const DicomSeries & series, const VolumeReadOptions & options);
} // namespace shapeton

#endif
