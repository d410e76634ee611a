#ifndef itkImageFile_h
#define itkImageFile_h

#include "itkVolumeReader.h"

#include <string>

namespace itk
{
/** True for the extensions of NRRD, NIfTI and MetaImage. */
bool
IsImageFile(const std::string & path);

/** Reads a NRRD, NIfTI or MetaImage file; image and identity of the result are set. Throws InputError. */
Volume
ReadImageFile(const std::string & path);

/** Bytes of the machine's memory. */
double
GetPhysicalMemory();
} // namespace itk

#endif
