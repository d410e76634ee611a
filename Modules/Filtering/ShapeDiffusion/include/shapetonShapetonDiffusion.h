#ifndef shapetonShapetonDiffusion_h
#define shapetonShapetonDiffusion_h

#include "shapetonDevice.h"
#include "shapetonShapetonDirection.h"
#include "shapetonShapetonState.h"
#include "shapetonVolumeGradientOperator.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace shapeton
{
/** What a step of a shapeton passes.
 * \ingroup ShapeDiffusion */
enum class PathRule
{
  /** As published (3.2.1): the step ends where it ends, whatever lies between. A long step jumps over walls. */
  Endpoint,
  /** The step is walked voxel by voxel: each face lets the shapeton pass with a probability equal to the weight of its
   * edge and reflects it otherwise. The place inside the voxel is drawn anew before each step, so that the shapetons
   * are a Markov chain on the voxels. With DirectionSampling::Uniform its transition matrix is symmetric, and for steps
   * shorter than a voxel the expected density obeys the operator of cumulative heat diffusion: see
   * EquivalentHeatTimeSteps(). */
  Traversal
};

/** Where shapetons start.
 * \ingroup ShapeDiffusion */
enum class ShapetonPlacement
{
  /** Anywhere in the volume, or in the mask, with the same probability (3.2). */
  Uniform,
  /** In proportion to the initial heat (2.3), inside the mask where there is one: their density is then to heat what a
   * sample is to its distribution. */
  InitialHeat
};

/** The names of the tool's options: "solidAngle", "endpoint", "initialHeat" and so on. \ingroup ShapeDiffusion */
///@{
ShapeDiffusion_EXPORT const char *
NameOf(DirectionSampling sampling);
ShapeDiffusion_EXPORT const char *
NameOf(PathRule rule);
ShapeDiffusion_EXPORT const char *
NameOf(ShapetonPlacement placement);
///@}

/** What to compute; see ShapetonDiffusionImageFilter for the meaning of each setting.
 * \ingroup ShapeDiffusion */
struct ShapetonDiffusionSettings
{
  /** Edge weights; its spacing, in mm, also scales the steps. The conductance does not matter. */
  VolumeGradientOperator::Parameters volumeGradient;
  std::uint32_t                      shapetons{ 65000 }; ///< at least 1
  double                             distance{ 0.01 };   ///< in (0, 1]
  DirectionSampling                  directionSampling{ DirectionSampling::SolidAngle };
  PathRule                           pathRule{ PathRule::Endpoint };
  ShapetonPlacement                  placement{ ShapetonPlacement::Uniform };
  std::uint64_t                      seed{ 1 };
  /** Where the shapetons move; the results are the same bytes. */
  Device device{ Device::Automatic };
};

/** When shapeton diffusion counts as steady: (3.10) holds in at least 90 % of the last 50 steps.
 * \ingroup ShapeDiffusion */
struct SteadyRule
{
  /** Greatest change of a step; see ShapetonMeasures::change. */
  double epsilon{ 0.05 };
  /** Take ShapetonMeasures::automaticEpsilon in its place. */
  bool automatic{ false };
};

/** How far a run has come. Exact: sums of whole numbers.
 * \ingroup ShapeDiffusion */
struct ShapetonMeasures
{
  std::uint64_t step{ 0 };
  std::uint32_t maximumVisits{ 0 }; ///< of the voxel that was visited most
  std::uint64_t voxelsReached{ 0 }; ///< voxels with at least one visit
  /** Object voxels: those of the mask; without one, those whose intensity lies above the lower end of the window, or
   * all where none does. */
  std::uint64_t objectVoxels{ 0 };
  std::uint64_t objectVoxelsReached{ 0 };
  /** Shapetons in voxels whose six weights are 0: they stay there for ever. */
  std::uint32_t trappedShapetons{ 0 };
  /** (3.10) with densities normalised to a greatest value of 1: the sum over the voxels of the squared change in this
   * step. As printed, with raw counts, it is never less than the number of shapetons. */
  double change{ 0.0 };
  /** The change at which the voxels reached have 100 visits on average, so that counts are right to about 10 %:
   * n (1 + n / R) / (100 M / m)^2 with n shapetons, R voxels reached, greatest and mean number of visits M and m. */
  double automaticEpsilon{ 0.0 };
  bool   steady{ false };

  /** The 'convergence' of Table 3.1: the share of the object voxels that were visited, in [0, 1]. */
  double
  GetCoverage() const
  {
    return objectVoxels == 0 ? 0.0 : static_cast<double>(objectVoxelsReached) / static_cast<double>(objectVoxels);
  }
};

/** \class ShapetonDiffusion
 * \brief Particles that move at random through a volume as its edge weights allow, and the visits of each voxel
 * (dissertation chapter 3).
 *
 * In each step a shapeton draws a direction from the six weights of its voxel (3.2.1), moves by a fixed distance, and
 * the voxel where it ends counts one visit. The distance is given in the unit cube around the volume: 1 is the longest
 * side of the volume in millimetres, and a step has the same length in millimetres in all directions. At the border of
 * the volume a shapeton is reflected; where all six weights are 0 it stays.
 *
 * Random numbers belong to the seed, the shapeton and the step (Philox4x32-10), and visits are whole numbers: results
 * have the same bytes for any number of threads, on any CPU, and however a run is cut into pieces.
 *
 * Weights are stored in units of 1 / 65535. Memory: 20 bytes a voxel, those of `visits` included, and 16 a shapeton.
 *
 * \ingroup ShapeDiffusion
 */
class ShapeDiffusion_EXPORT ShapetonDiffusion
{
public:
  /** Called on the calling thread at the end of a step, every few hundredths of a second unless a step takes longer;
   * may throw to abort. `visits` and GetPlaces() are those of that step. */
  using Observer = std::function<void(const ShapetonMeasures &)>;

  /** Places the shapetons. `intensities` and `mask` (may be null: no mask; else 0 is outside) hold size[0] * size[1] *
   * size[2] values, x fastest, and are not needed afterwards. `visits` holds as many and must outlive the object; it is
   * set to 0. `poll` is called now and then, by Run() in the middle of long steps, and may throw to abort: the object
   * is of no use then. Throws std::invalid_argument for settings out of range, std::domain_error where no shapeton can
   * be placed (an empty mask; no initial heat), std::length_error for 2^31 voxels or more, or 2^24 along an axis,
   * DeviceError where the device cannot be used. */
  ShapetonDiffusion(const float *                      intensities,
                    const std::array<std::size_t, 3> & size,
                    const ShapetonDiffusionSettings &  settings,
                    const unsigned char *              mask,
                    std::uint32_t *                    visits,
                    const std::function<void()> &      poll = {});
  ~ShapetonDiffusion();
  ShapetonDiffusion(const ShapetonDiffusion &) = delete;
  ShapetonDiffusion &
  operator=(const ShapetonDiffusion &) = delete;

  /** Takes steps until `lastStep` has been taken, or until the rule, if there is one, finds the density steady. With a
   * rule every step is measured, which takes twice as long. Throws std::overflow_error when a voxel would be visited
   * more often than 32 bits can count. */
  void
  Run(std::uint64_t lastStep, const std::optional<SteadyRule> & rule = {}, const Observer & observer = {});

  const ShapetonMeasures &
  GetMeasures() const;

  /** Where the shapetons move. */
  const DeviceUse &
  GetDeviceUse() const;

  /** Places in voxels along an axis: the voxel of index i holds the places from i to i + 1. */
  const float *
  GetPlaces(unsigned int axis) const;

  /** All that is needed to go on later: places, visits, measures. */
  ShapetonState
  GetState() const;

  /** Goes on from a state. Throws std::invalid_argument, which names the difference, when the state is of another
   * volume or of other settings. */
  void
  SetState(const ShapetonState & state);

private:
  struct Impl;
  std::unique_ptr<Impl> m_Impl;
};

/** The number of time steps of cumulative heat diffusion after which heat has spread as far as shapetons after
 * `steps` steps of `stepInVoxels` smallest spacings, with PathRule::Traversal and DirectionSampling::Uniform:
 * the mean squared displacement of both along an axis is the same where there are no walls,
 *
 *   2 dt t = steps (a^2 / 3 + (n / 6 + f^2 / 2 - f^3 / 3) / a), which is steps (a / 2) for a <= 1,
 *
 * a = stepInVoxels, n and f its whole and its broken part. The open question 7.2.1 of the dissertation; valid on cubic
 * voxels. `timeStepLength` is dt. \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT double
EquivalentHeatTimeSteps(double steps, double stepInVoxels, double timeStepLength);
} // namespace shapeton

#endif
