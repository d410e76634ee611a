#ifndef shapetonParticlePreset_h
#define shapetonParticlePreset_h

#include "shapetonHeatParameterChoice.h"
#include "shapetonParticleParameters.h"
#include "shapetonShapetonPresetOptions.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace shapeton
{
/** The values of the preset that do not depend on intensities, for a volume of `size` voxels of `spacing` mm; p and
 * other options keep their defaults. \ingroup ShapetonParticles */
ShapetonParticles_EXPORT ParticleDiffusionOptions
OptionsOfPreset(ShapetonPreset preset, const std::array<std::size_t, 3> & size, const std::array<double, 3> & spacing);

/** Options chosen from the data, and why. \ingroup ShapetonParticles */
struct ShapetonParameterChoice
{
  ParticleDiffusionOptions options;
  HeatParameterChoice      heat;    ///< the choice on which they are based; without reasons if published
  AutomaticShapetons       feature; ///< reasons for what was derived from the feature size
};

/** The options; those whose names are not in `given` are set by the preset, except seed, untilSteady, epsilon and
 * device, which no preset determines. The duration of Objects is twice
 * EquivalentHeatTimeSteps() of the chosen heat diffusion time, because visits accumulate from the first step. It is
 * limited so that the total number of visits allows 20,000 to 200,000 shapetons, depending on the size of the volume.
 * The number of shapetons is chosen for 200 visits per voxel on average, but at most 1e8 visits in total. With a
 * feature size, ChooseShapetons() replaces the distance, and the number of shapetons unless it is given.
 *
 * Throws ParameterError for options out of range, and the exceptions of
 * ChooseShapetons().
 * \ingroup ShapetonParticles */
ShapetonParticles_EXPORT ShapetonParameterChoice
ChooseShapetonParameters(const VolumeView &               volume,
                         const ShapetonPresetOptions &    options,
                         const std::vector<std::string> & given = {},
                         const Progress &                 progress = {});
} // namespace shapeton

#endif
