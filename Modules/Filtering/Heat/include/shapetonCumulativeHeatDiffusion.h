#ifndef shapetonCumulativeHeatDiffusion_h
#define shapetonCumulativeHeatDiffusion_h

#include "shapetonCumulativeHeatDiffusionOptions.h"
#include "shapetonHeatClasses.h"
#include "shapetonHeatHistogram.h"
#include "shapetonShapeComponents.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace shapeton
{
/** Settings of DiffuseCumulativeHeat(). \ingroup ShapetonHeat */
struct CumulativeHeatDiffusionSettings : CumulativeHeatDiffusionOptions
{
  /** Rows of the heat histogram; ascending, at most timeSteps. */
  std::vector<std::uint64_t> histogramSteps{};
  /** Steps whose heat is passed to the consumer; ascending, at most timeSteps. */
  std::vector<std::uint64_t> snapshotSteps{};
  /** Whether to find components and classes. */
  bool          wantComponents{ false };
  std::uint64_t minimumComponentVoxels{ 27 };
};

/** Result of a run, except for the heat, and the parameters used.
 * \ingroup ShapetonHeat */
struct CumulativeHeatDiffusionResult
{
  double                      p{ 0.0 };
  double                      smoothing{ 0.0 }; ///< mm
  double                      windowLower{ 0.0 };
  double                      windowUpper{ 0.0 };
  double                      timeStepLength{ 0.0 };
  std::uint64_t               timeStep{ 0 }; ///< last completed step
  bool                        steady{ false };
  bool                        cold{ false }; ///< no edge in the volume: the heat is 0 everywhere
  std::uint64_t               operatorApplications{ 0 };
  std::string                 device; ///< device used; see DeviceUse::Describe()
  HeatHistogram               histogram;
  std::vector<ShapeComponent> components;
  std::vector<HeatClass>      classes; ///< with coherence; only if components are wanted
};

/** Receives the heat after `step`, one value per voxel of the volume, x fastest.
 * \ingroup ShapetonHeat */
using HeatSnapshotConsumer = std::function<void(std::uint64_t step, const std::vector<float> & heat)>;

/** Cumulative heat diffusion of a volume: all voxels are sources at once (dissertation 2.2.1). `heat` and `initialHeat`
 * (may be null) have one value per voxel, x fastest; `heat` may be the array of the volume. A copy of pixels that only
 * `volume` owns is released before the diffusion. The components use the spacing even if the diffusion ignores it.
 * `progress` is called on this thread and may throw to abort. The filter and the tools use this implementation.
 * \ingroup ShapetonHeat */
ShapetonHeat_EXPORT CumulativeHeatDiffusionResult
DiffuseCumulativeHeat(VolumeView                              volume,
                      const CumulativeHeatDiffusionSettings & settings,
                      float *                                 heat,
                      float *                                 initialHeat = nullptr,
                      const HeatSnapshotConsumer &            consumer = {},
                      const Progress &                        progress = {});
} // namespace shapeton

#endif
