#ifndef shapetonVolumeFileServices_h
#define shapetonVolumeFileServices_h

#include "ShapetonVolumeFilesExport.h"

#include "shapetonContainedProcess.h"

namespace shapeton
{
/** The parsers of this library for the program ShapetonFileParser. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT ContainedServices
VolumeFileServices();
} // namespace shapeton

#endif
