#ifndef shapetonObjectHeat_h
#define shapetonObjectHeat_h

#include "shapetonShapeOccupancy.h"
#include "shapetonShapeSignature.h"

namespace shapeton
{
/** The remaining fraction of heat of an object in surroundings of heat 0, at times in squared voxels; see
 * ShapeSignature::remainingHeat. Throws InputError if most of the object is less than half a voxel thick. */
ShapeSignature::Curve
RemainingHeat(const ShapeOccupancy & occupancy, const ShapeSignature::Curve & times);

/** The mean squared displacement of heat in an insulated object, in squared voxels. */
ShapeSignature::Curve
MeanSquareDisplacement(const ShapeOccupancy & occupancy, const ShapeSignature::Curve & times);
} // namespace shapeton

#endif
