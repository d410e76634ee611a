#ifndef shapetonDicomResultServices_h
#define shapetonDicomResultServices_h

#include "ShapetonDicomResultsExport.h"

#include "shapetonContainedProcess.h"

namespace shapeton
{
/** The parsers of this library for the program ShapetonFileParser. \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT ContainedServices
DicomResultServices();
} // namespace shapeton

#endif
