#ifndef shapetonOrthonormalDirection_h
#define shapetonOrthonormalDirection_h

#include "ShapetonPhantomsExport.h"

#include "itkMatrix.h"

namespace shapeton
{
/** Removes the rounding of typed direction cosines: makes the columns of a matrix perpendicular unit vectors,
 * preserving the direction of the first, the plane of the first two, and the handedness. Returns false and changes
 * nothing if a scalar product of two columns is wrong by more than `tolerance`, or not finite.
 * \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT bool
MakeOrthonormal(itk::Matrix<double, 3, 3> & direction, double tolerance);

/** True if the third column is opposite to the cross product of the first two.
 * \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT bool
IsLeftHanded(const itk::Matrix<double, 3, 3> & direction);
} // namespace shapeton

#endif
