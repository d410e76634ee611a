#ifndef shapetonParticleParameters_h
#define shapetonParticleParameters_h

#include "ShapetonParticlesExport.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace shapeton
{
/** Distance and number of shapetons, derived from the volume and its feature size, with the reason.
 * \ingroup ShapetonParticles */
struct AutomaticShapetons
{
  double        distance{ 0.0 }; ///< in (0, 1], as ParticleOptions::distance
  std::string   distanceReason;
  std::uint32_t shapetons{ 0 };
  std::string   shapetonsReason;
};

/** Chooses the step and the number of shapetons (3.4.1, 3.4.2).
 *
 * A step longer than a feature skips it (Figure 3.7), so the step is half of `featureSize` (mm). Too few shapetons do
 * not cover the volume (Figure 3.6). Their number yields 20 visits per voxel on average in `timeSteps` steps, and at
 * least three start positions in the volume of a feature; it is a multiple of 1000 in [1000, 10,000,000].
 *
 * `size` in voxels, `spacing` in mm. Throws InputError for a feature smaller than a voxel or larger than the
 * volume. \ingroup ShapetonParticles */
ShapetonParticles_EXPORT AutomaticShapetons
ChooseShapetons(const std::array<std::size_t, 3> & size,
                const std::array<double, 3> &      spacing,
                double                             featureSize,
                std::uint64_t                      timeSteps);
} // namespace shapeton

#endif
