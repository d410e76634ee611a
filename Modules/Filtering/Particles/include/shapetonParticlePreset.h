#ifndef shapetonParticlePreset_h
#define shapetonParticlePreset_h

#include "shapetonHeatParameterChoice.h"
#include "shapetonParticleDiffusionOptions.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace shapeton
{
/** Values of the options of shapeton diffusion for a purpose.
 * \ingroup ShapetonParticles */
enum class ShapetonPreset
{
  /** Separates objects: the walk that samples cumulative heat diffusion (traversal, uniform directions, started by
   * initial heat) with steps of two voxels. Window, p, smoothing and duration are chosen by ChooseHeatParameters(). */
  Objects,
  /** As printed in chapter 3: sectorArea, endpoint, started anywhere, 65,000 shapetons, distance 0.01, 2,500 steps,
   * p = 7, the whole range. */
  Published,
  /** Distinguishes thin from compact parts: 100 steps of one voxel of the walk of Objects, a spread of 7 voxels along
   * each axis, so that visits show the surface area per volume of the neighborhood. Window, p, smoothing are chosen. */
  Surface
};

/** The values of the preset that do not depend on intensities, for a volume of `size` voxels of `spacing` mm; p and so
 * on keep the defaults of the options. \ingroup ShapetonParticles */
ShapetonParticles_EXPORT ParticleDiffusionOptions
OptionsOfPreset(ShapetonPreset preset, const std::array<std::size_t, 3> & size, const std::array<double, 3> & spacing);

/** Sets all options whose names are not in `given` to the values of the preset; returns the reasons for those that were
 * chosen from the intensities. The duration of Objects is twice EquivalentHeatTimeSteps() of the chosen time of heat,
 * because visits accumulate from the first step, but at most as long as 20,000 to 200,000 shapetons, by the size of the
 * volume, can walk. The number of shapetons gives each voxel 200 visits on average, in total at most 1e8.
 *
 * `modality` as for ChooseHeatParameters(). Throws ParameterError for options out of range.
 * \ingroup ShapetonParticles */
ShapetonParticles_EXPORT HeatParameterChoice
ChooseShapetonParameters(const float *                      intensities,
                         const std::array<std::size_t, 3> & size,
                         const std::array<double, 3> &      spacing,
                         ShapetonPreset                     preset,
                         const std::vector<std::string> &   given,
                         const std::string &                modality,
                         ParticleDiffusionOptions &         options,
                         const Progress &                   progress = {});
} // namespace shapeton

#endif
