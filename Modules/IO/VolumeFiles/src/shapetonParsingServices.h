#ifndef shapetonParsingServices_h
#define shapetonParsingServices_h

#include "shapetonContainedProcess.h"

// The services of this library in the contained process, and their names.

namespace shapeton
{
/** Names of the services of ShapetonFileParser. */
constexpr const char * DicomHeaderService = "DicomHeader";
constexpr const char * DicomPixelService = "DicomPixels";
constexpr const char * ImageFileService = "ImageFile";

/** Parses the headers of DICOM files. */
ContainedService
MakeDicomHeaderService();

/** Decodes the frames of DICOM files. */
ContainedService
MakeDicomPixelService();

/** Reads the headers and voxels of NRRD, NIfTI and MetaImage files. */
ContainedService
MakeImageFileService();
} // namespace shapeton

#endif
