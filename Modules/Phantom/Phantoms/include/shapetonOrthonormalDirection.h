#ifndef shapetonOrthonormalDirection_h
#define shapetonOrthonormalDirection_h

#include "ShapetonPhantomsExport.h"

#include "itkMatrix.h"

namespace shapeton
{
/** Orthonormalizes rounded direction cosines. The direction of the first column, the plane of the first two, and the
 * handedness are preserved. Returns false without changes if a scalar product of two columns deviates by more than
 * `tolerance` or is not finite.
 * \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT bool
MakeOrthonormal(itk::Matrix<double, 3, 3> & direction, double tolerance);

/** Whether the matrix is left-handed.
 * \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT bool
IsLeftHanded(const itk::Matrix<double, 3, 3> & direction);
} // namespace shapeton

#endif
