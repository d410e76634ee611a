#ifndef shapetonObjectHeat_h
#define shapetonObjectHeat_h

#include "shapetonShapeOccupancy.h"
#include "shapetonShapeSignature.h"

namespace shapeton
{
/** The share of its heat that an object in surroundings of heat 0 still has, at times in units of squared voxels; see
 * ShapeSignature::remainingHeat. Throws InputError where too little of the object is at least half a voxel thick. */
ShapeSignature::Curve
RemainingHeat(const ShapeOccupancy & occupancy, const ShapeSignature::Curve & times);

/** The mean square displacement of heat that cannot leave, in squared voxels. */
ShapeSignature::Curve
MeanSquareDisplacement(const ShapeOccupancy & occupancy, const ShapeSignature::Curve & times);
} // namespace shapeton

#endif
