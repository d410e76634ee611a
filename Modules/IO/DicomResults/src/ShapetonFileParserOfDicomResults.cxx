#include "shapetonDicomResultServices.h"

// A part of the program ShapetonFileParser.

namespace
{
const shapeton::AddContainedServices dicomResults(shapeton::DicomResultServices());
}
