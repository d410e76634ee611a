#ifndef InterpolatedWalk_h
#define InterpolatedWalk_h

#include "ShapetonTrial.h"

/** Trial of shapetons whose edge weights are interpolated at their position, a reading of 3.2 that the product does not
 * offer: the six weights follow from the trilinear intensities at the shapeton and one voxel away from it along each
 * axis. Directions are drawn by solid angle, steps jump. With ParticlePlacement::InitialHeat, directions are uniform
 * instead, and a step is taken with the weight between the intensities at its ends, else the shapeton stays. Voxels
 * must be cubes. */
Trial
RunInterpolatedShapetons(const TrialVolume &         volume,
                         double                      p,
                         const WalkSettings &        settings,
                         shapeton::ParticlePlacement placement,
                         std::uint64_t               seed);

#endif
