#ifndef shapetonParticleDiffusion_h
#define shapetonParticleDiffusion_h

#include "shapetonDevice.h"
#include "shapetonParticleDirection.h"
#include "shapetonParticleDiffusionOptions.h"
#include "shapetonParticleState.h"
#include "shapetonVolumeGradientOperator.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace shapeton
{
/** Steady rule of shapeton diffusion: (3.10) holds in at least 90 % of the last 50 steps.
 * \ingroup ShapetonParticles */
struct SteadyRule
{
  /** Largest change of a step; see ParticleMeasures::change. */
  double epsilon{ *ParticleDiffusionOptions().epsilon };
  /** Use ParticleMeasures::automaticEpsilon instead. */
  bool automatic{ false };
};

/** Measures of a run, exact because they are sums of integers.
 * \ingroup ShapetonParticles */
struct ParticleMeasures
{
  std::uint64_t step{ 0 };
  std::uint32_t maximumVisits{ 0 }; ///< visits of the most visited voxel
  std::uint64_t voxelsReached{ 0 }; ///< voxels with at least one visit
  /** Object voxels: those of the mask. Without a mask, those with an intensity above the lower end of the window, or
   * all voxels if there are none. */
  std::uint64_t objectVoxels{ 0 };
  std::uint64_t objectVoxelsReached{ 0 };
  /** Shapetons in voxels whose six weights are all 0; they never move. */
  std::uint32_t trappedShapetons{ 0 };
  /** (3.10) with densities normalized to a maximum of 1: the sum over the voxels of the squared change in this step.
   * With raw counts, as printed, it is never less than the number of shapetons. */
  double change{ 0.0 };
  /** The change at which the reached voxels have 100 visits on average, so that counts are accurate to about 10 %: n
   * (1 + n / R) / (100 M / m)^2 with n shapetons, R reached voxels, maximum and mean number of visits M and m. */
  double automaticEpsilon{ 0.0 };
  bool   steady{ false };

  /** 'Convergence' of Table 3.1: the fraction of object voxels with visits, in [0, 1]. */
  double
  GetCoverage() const
  {
    return objectVoxels == 0 ? 0.0 : static_cast<double>(objectVoxelsReached) / static_cast<double>(objectVoxels);
  }
};

/** \class ParticleDiffusion
 * \brief Random walk of particles through a volume according to its edge weights, counting the visits to each voxel
 * (dissertation chapter 3).
 *
 * In each step a shapeton draws a direction from the six weights of its voxel (3.2.1), moves by a fixed distance, and
 * the voxel where it ends counts one visit. The distance is a fraction of the longest side of the volume in
 * millimeters, equal in all directions. A shapeton is reflected at the border of the volume and does not move if all
 * six weights are 0.
 *
 * Random numbers depend only on the seed, the shapeton and the step (Philox4x32-10), and visits are integers, so
 * results are bitwise identical for any number of threads, any CPU, and any division of a run.
 *
 * Weights are stored in units of 1 / 65535. Memory: 20 bytes per voxel, including `visits`, and 16 per shapeton.
 *
 * \ingroup ShapetonParticles */
class ShapetonParticles_EXPORT ParticleDiffusion
{
public:
  /** Called on the calling thread at the end of a step, every few hundredths of a second unless a step takes longer;
   * may throw to abort. `visits` and GetPlaces() are up to date. */
  using Observer = std::function<void(const ParticleMeasures &)>;

  /** Places the shapetons. `mask` (null: no mask; 0 is outside) has one value per voxel; like the volume, it is not
   * needed afterwards. `visits` has the same size, is set to 0 and must outlive the object. The options for the end of
   * the run are ignored. `poll` is called occasionally, also during long steps of Run(), and may throw to abort; the
   * object must not be used afterwards. Throws ParameterError for options out of range, InputError if no shapeton
   * can be placed (an empty mask; no initial heat) and for 2^31 voxels or more, or 2^24 along an axis, DeviceError if
   * the device cannot be used. */
  ParticleDiffusion(const VolumeView &               volume,
                    const ParticleDiffusionOptions & options,
                    const unsigned char *            mask,
                    std::uint32_t *                  visits,
                    const std::function<void()> &    poll = {});
  ~ParticleDiffusion();
  ParticleDiffusion(const ParticleDiffusion &) = delete;
  ParticleDiffusion &
  operator=(const ParticleDiffusion &) = delete;

  /** Performs steps up to `lastStep`, or until the density is steady by the rule, if given. With a rule every step is
   * measured, which doubles the run time. Throws InputError if the visits of a voxel exceed 32 bits. */
  void
  Run(std::uint64_t lastStep, const std::optional<SteadyRule> & rule = {}, const Observer & observer = {});

  const ParticleMeasures &
  GetMeasures() const;

  /** Device that moves the shapetons. */
  const DeviceUse &
  GetDeviceUse() const;

  /** Positions in voxels along an axis: the voxel of index i covers the interval from i to i + 1. */
  const float *
  GetPlaces(unsigned int axis) const;

  /** The state needed to continue later: positions, visits, measures. */
  ParticleState
  GetState() const;

  /** Continues from a state. Throws InputError if the state belongs to another volume or to other settings;
   * the message states the difference. */
  void
  SetState(const ParticleState & state);

private:
  struct Impl;
  std::unique_ptr<Impl> m_Impl;
};

/** Number of time steps of cumulative heat diffusion in which heat spreads as far as shapetons in `steps` steps of
 * `stepInVoxels` smallest spacings, with PathRule::Traversal and DirectionSampling::Uniform. Without walls the mean
 * squared displacements along an axis are equal:
 *
 *   2 dt t = steps (a^2 / 3 + (n / 6 + f^2 / 2 - f^3 / 3) / a), equal to steps (a / 2) for a <= 1,
 *
 * a = stepInVoxels, n and f its integer and fractional part. This answers the open question 7.2.1 of the
 * dissertation; valid for cubic voxels. `timeStepLength` is dt. \ingroup ShapetonParticles */
ShapetonParticles_EXPORT double
EquivalentHeatTimeSteps(double steps, double stepInVoxels, double timeStepLength);
} // namespace shapeton

#endif
