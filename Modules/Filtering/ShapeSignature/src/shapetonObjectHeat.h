#ifndef shapetonObjectHeat_h
#define shapetonObjectHeat_h

#include "shapetonShapeOccupancy.h"
#include "shapetonShapeSignature.h"

namespace shapeton
{
/** The remaining share of heat of an object with surroundings of heat 0, at times in units of squared voxels; see
 * ShapeSignature::remainingHeat. Throws InputError if too little of the object is at least half a voxel thick. */
ShapeSignature::Curve
RemainingHeat(const ShapeOccupancy & occupancy, const ShapeSignature::Curve & times);

/** The mean squared displacement of heat that cannot leave, in squared voxels. */
ShapeSignature::Curve
MeanSquareDisplacement(const ShapeOccupancy & occupancy, const ShapeSignature::Curve & times);
} // namespace shapeton

#endif
