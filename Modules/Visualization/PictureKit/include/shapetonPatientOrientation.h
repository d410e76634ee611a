#ifndef shapetonPatientOrientation_h
#define shapetonPatientOrientation_h

#include "PictureKitExport.h"

#include "itkVector.h"

#include <string>

namespace shapeton
{
/** The letters of a direction in LPS, as radiologists write them at the border of a picture: R or L, A or P, H (head)
 * or F (feet), the strongest component first; components below a quarter of the length are left out. Empty for a zero
 * vector. \ingroup PictureKit */
PictureKit_EXPORT std::string
                  OrientationLetters(const itk::Vector<double, 3> & direction);
} // namespace shapeton

#endif
