#ifndef ScalarPeer_h
#define ScalarPeer_h

#include "shapetonVolumeGradientOperator.h"

/** One explicit step in a straightforward implementation: one loop over the voxels, scalar, single-threaded. */
void
ScalarStep(const shapeton::VolumeGradientOperator & volumeGradient, const float * f, float * out, float dt);

#endif
