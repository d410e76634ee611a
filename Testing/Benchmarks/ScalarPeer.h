#ifndef ScalarPeer_h
#define ScalarPeer_h

#include "shapetonVolumeGradientOperator.h"

/** One explicit step as anyone would write it: one loop over the voxels, no vectors, one thread. */
void
ScalarStep(const shapeton::VolumeGradientOperator & volumeGradient, const float * f, float * out, float dt);

#endif
