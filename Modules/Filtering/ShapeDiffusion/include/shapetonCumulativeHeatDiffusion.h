#ifndef shapetonCumulativeHeatDiffusion_h
#define shapetonCumulativeHeatDiffusion_h

#include "shapetonAutomaticParameters.h"
#include "shapetonHeatDiffusionSolver.h"
#include "shapetonHeatHistogram.h"
#include "shapetonShapeComponents.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace shapeton
{
/** What to compute; see CumulativeHeatDiffusionImageFilter for the meaning of each setting.
 * \ingroup ShapeDiffusion */
struct CumulativeHeatDiffusionSettings
{
  VolumeGradientOperator::Parameters volumeGradient;
  /** Let ChooseP() find p from the data. */
  bool                        automaticP{ false };
  HeatDiffusionSolver::Method method{ HeatDiffusionSolver::Method::Chebyshev };
  std::uint64_t               timeSteps{ 100000 };
  double                      timeStepLength{ HeatDiffusionSolver::MaximumTimeStepLength };
  double                      tolerance{ 1e-5 };
  bool                        untilSteady{ false };
  /** Rows of the heat histogram; ascending. */
  std::vector<std::uint64_t> histogramSteps;
  /** Steps whose heat is handed out; ascending. */
  std::vector<std::uint64_t> snapshotSteps;
  bool                       wantComponents{ false };
  /** Spacing in mm for the components, also where the diffusion ignores it. */
  std::array<double, 3> spacing{ { 1.0, 1.0, 1.0 } };
  std::uint64_t         minimumComponentVoxels{ 27 };
  /** Where the heat is computed; the results are the same bytes. */
  Device device{ Device::Automatic };
};

/** What a run found besides the heat, and the parameters that it used.
 * \ingroup ShapeDiffusion */
struct CumulativeHeatDiffusionResult
{
  AutomaticP                  p; ///< with a reason only where it was automatic
  double                      windowLower{ 0.0 };
  double                      windowUpper{ 0.0 };
  double                      timeStepLength{ 0.0 };
  std::uint64_t               timeStep{ 0 }; ///< the last step that was taken
  bool                        steady{ false };
  bool                        cold{ false }; ///< no edge in the volume: the heat is 0 everywhere
  std::uint64_t               operatorApplications{ 0 };
  std::string                 device; ///< where it was computed; see DeviceUse::Describe()
  HeatHistogram               histogram;
  std::vector<ShapeComponent> components;
};

/** Receives the heat after `step`: as many values as the volume has voxels, x fastest.
 * \ingroup ShapeDiffusion */
using HeatSnapshotConsumer = std::function<void(std::uint64_t step, const std::vector<float> & heat)>;

/** Cumulative heat diffusion of a volume: all voxels are sources at once (dissertation 2.2.1). `intensities`, `heat`
 * and `initialHeat` (may be null) hold size[0] * size[1] * size[2] values, x fastest; `intensities` and `heat` may be
 * the same array. `progress` is called on this thread and may throw to abort. This is the one implementation; the
 * filter and the tools call it. \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT CumulativeHeatDiffusionResult
DiffuseCumulativeHeat(const float *                           intensities,
                      const std::array<std::size_t, 3> &      size,
                      const CumulativeHeatDiffusionSettings & settings,
                      float *                                 heat,
                      float *                                 initialHeat = nullptr,
                      const HeatSnapshotConsumer &            consumer = {},
                      const Progress &                        progress = {});
} // namespace shapeton

#endif
