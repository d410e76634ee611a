#ifndef shapetonHiddenInBoth_h
#define shapetonHiddenInBoth_h

#include "ShapetonSupineProneExport.h"

#include "shapetonColonAssessability.h"
#include "shapetonColonPosition.h"

namespace shapeton
{
/** The parts of a colon whose wall neither position shows: the hindered stretches of the first position where the
 * second one is hindered, too, at the mean distance to which the map takes the wall. With the reasons and distances
 * (arcLength, mm) of the first position. \param firstToSecond RegistrationResults::supineToProne, if the first position
 * is the supine one. Throws InputError if it lacks the array mappedUv. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT std::vector<HinderedStretch>
FindHiddenInBoth(const ColonPosition & first, const ColonPosition & second, const SurfaceMesh & firstToSecond);
} // namespace shapeton

#endif
