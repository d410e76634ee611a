#ifndef shapetonHiddenInBoth_h
#define shapetonHiddenInBoth_h

#include "ShapetonSupineProneExport.h"

#include "shapetonColonAssessability.h"
#include "shapetonColonPosition.h"

namespace shapeton
{
/** Finds the parts of a colon whose wall is not visible in either position. These are the hindered stretches of the
 * first position that are mapped to hindered stretches of the second one; the distance along the second centerline is
 * the mean around the tube. Reasons and distances (arcLength, mm) are those of the first position. \param firstToSecond
 * RegistrationResults::supineToProne, if the first position is the supine one. Throws InputError if it lacks the array
 * mappedUv. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT std::vector<HinderedStretch>
FindHiddenInBoth(const ColonPosition & first, const ColonPosition & second, const SurfaceMesh & firstToSecond);
} // namespace shapeton

#endif
