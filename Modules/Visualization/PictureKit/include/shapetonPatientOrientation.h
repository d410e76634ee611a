#ifndef shapetonPatientOrientation_h
#define shapetonPatientOrientation_h

#include "ShapetonPictureKitExport.h"

#include "itkVector.h"

#include <string>

namespace shapeton
{
/** Orientation letters of an LPS direction, as shown at the border of radiological pictures: R or L, A or P, H (head)
 * or F (feet), the largest component first; components below a quarter of the length are omitted. Empty for a zero
 * vector. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT std::string
                          OrientationLetters(const itk::Vector<double, 3> & direction);
} // namespace shapeton

#endif
