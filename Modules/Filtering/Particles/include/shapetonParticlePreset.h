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
/** The values of the preset that do not depend on intensities, for a volume of `size` voxels of `spacing` mm; p and so
 * on keep the defaults of the options. \ingroup ShapetonParticles */
ShapetonParticles_EXPORT ParticleDiffusionOptions
OptionsOfPreset(ShapetonPreset preset, const std::array<std::size_t, 3> & size, const std::array<double, 3> & spacing);

/** Options chosen from the data, and why. \ingroup ShapetonParticles */
struct ShapetonParameterChoice
{
  ParticleDiffusionOptions options;
  HeatParameterChoice      heat;    ///< the choice on which they are based; without reasons if published
  AutomaticShapetons       feature; ///< reasons for what was derived from the feature size
};

/** The options, those whose names are not in `given` by the preset. The duration of Objects is twice
 * EquivalentHeatTimeSteps() of the chosen time of heat, because visits accumulate from the first step, but at most as
 * long as 20,000 to 200,000 shapetons, by the size of the volume, can walk. The number of shapetons gives each voxel
 * 200 visits on average, in total at most 1e8. With a feature size, ChooseShapetons() replaces the distance, and the
 * number of shapetons unless it is given.
 *
 * `modality` as for ChooseHeatParameters(). Throws ParameterError for options out of range, and as ChooseShapetons().
 * \ingroup ShapetonParticles */
ShapetonParticles_EXPORT ShapetonParameterChoice
ChooseShapetonParameters(const VolumeView &               volume,
                         const ShapetonPresetOptions &    options,
                         const std::vector<std::string> & given = {},
                         const std::string &              modality = {},
                         const Progress &                 progress = {});
} // namespace shapeton

#endif
