#ifndef BenchmarkVolume_h
#define BenchmarkVolume_h

#include "shapetonVolumeGradientOperator.h"

#include <array>
#include <cstddef>
#include <vector>

/** Three balls of soft edges on an uneven ground, in noise: 0 to 255 like the classic volumes, x fastest. */
std::vector<float>
MakeBenchmarkVolume(const std::array<std::size_t, 3> & size);

/** The window from the least to the greatest intensity; all else as by default. */
shapeton::VolumeGradientOperator::Parameters
WholeWindow(const std::vector<float> & intensities);

#endif
