#ifndef itkDicomVolume_h
#define itkDicomVolume_h

#include "itkDicomSeriesScan.h"
#include "itkVolumeReader.h"

namespace itk
{
/** Reads the pixels of a series and makes the repairs that the options ask for and the series needs. The series must
 * have no other defect. Throws InputError. */
Volume
ReadDicomVolume(const DicomSeries & series, const VolumeReadOptions & options);
} // namespace itk

#endif
