#include "InterpolatedWalk.h"

#include "shapetonParallelFor.h"
#include "shapetonParticleDiffusion.h"
#include "shapetonPhiloxStream.h"
#include "shapetonPi.h"
#include "shapetonVisitDensity.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <mutex>

using namespace shapeton;

namespace
{
constexpr std::uint32_t purposeOfWalk = 0x496E7470U;

/** The scaled intensities of a volume between the centers of its voxels. */
class Interpolator
{
public:
  Interpolator(const TrialVolume & volume, double p)
    : m_Values(volume.image->GetBufferPointer())
    , m_Size(volume.image->GetLargestPossibleRegion().GetSize())
    , m_Steepness(p / (volume.upper - volume.lower))
  {}

  double
  operator()(const Eigen::Array3d & place) const
  {
    std::size_t low[3], high[3];
    double      share[3];
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const double at = std::clamp(place[axis] - 0.5, 0.0, static_cast<double>(m_Size[axis] - 1));
      low[axis] = static_cast<std::size_t>(at);
      high[axis] = std::min<std::size_t>(low[axis] + 1, m_Size[axis] - 1);
      share[axis] = at - static_cast<double>(low[axis]);
    }
    const auto row = [&](std::size_t y, std::size_t z) {
      const float * const values = m_Values + (z * m_Size[1] + y) * m_Size[0];
      return values[low[0]] + share[0] * (values[high[0]] - values[low[0]]);
    };
    const auto plane = [&](std::size_t z) { return row(low[1], z) + share[1] * (row(high[1], z) - row(low[1], z)); };
    return plane(low[2]) + share[2] * (plane(high[2]) - plane(low[2]));
  }

  /** Edge weight between two intensities, see VolumeGradientOperator. */
  double
  Weight(double a, double b) const
  {
    return std::max(0.0, 1.0 - m_Steepness * std::abs(a - b));
  }

  std::size_t
  VoxelAt(const Eigen::Array3d & place) const
  {
    const auto index = [&](unsigned int axis) { return static_cast<std::size_t>(place[axis]); };
    return (index(2) * m_Size[1] + index(1)) * m_Size[0] + index(0);
  }

  /** Reflects a position at the border of the volume. */
  void
  Reflect(Eigen::Array3d & place) const
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const auto       side = static_cast<double>(m_Size[axis]);
      constexpr double margin = 1e-9; // keeps it inside
      place[axis] = place[axis] < 0.0 ? -place[axis] : place[axis] > side ? 2.0 * side - place[axis] : place[axis];
      place[axis] = std::clamp(place[axis], 0.0, side - margin);
    }
  }

private:
  const float * m_Values;
  itk::Size<3>  m_Size;
  double        m_Steepness;
};

Eigen::Array3d
AnyDirection(PhiloxStream & random)
{
  const double z = 2.0 * random.Unit() - 1.0, angle = shapeton::TwoPi * random.Unit();
  const double radius = std::sqrt(1.0 - z * z);
  return { radius * std::cos(angle), radius * std::sin(angle), z };
}

/** (8.3) and (8.4) for the octant of a direction. */
double
RadiusOf(const Eigen::Array3d & weights, const Eigen::Array3d & direction)
{
  const Eigen::Array3d d = direction.abs();
  const double         u = 2.0 / shapeton::Pi * std::acos(std::min(1.0, d[0]));
  const double         s = 2.0 / shapeton::Pi * std::atan2(d[2], d[1]);
  return weights[0] * (1.0 - u) + (weights[1] * (1.0 - s) + weights[2] * s) * u;
}

/** Moves by solid angle: rejection with the cube of the radius. Does not move if all weights are 0. */
void
MoveByWeights(const Interpolator & volume, double step, PhiloxStream & random, Eigen::Array3d & place)
{
  const double   here = volume(place);
  Eigen::Array3d weights[2]; // backwards, forwards
  double         greatest = 0.0;
  for (unsigned int edge = 0; edge < 6; ++edge)
  {
    Eigen::Array3d there = place;
    there[edge / 2] += edge % 2 == 0 ? -1.0 : 1.0;
    weights[edge % 2][edge / 2] = volume.Weight(here, volume(there));
    greatest = std::max(greatest, weights[edge % 2][edge / 2]);
  }
  while (greatest > 0.0)
  {
    const Eigen::Array3d direction = AnyDirection(random);
    const Eigen::Array3d octant = (direction < 0.0).select(weights[0], weights[1]);
    if (random.Unit() < std::pow(RadiusOf(octant, direction) / greatest, 3.0))
    {
      place += step * direction;
      return;
    }
  }
}

/** Moves by a uniform direction with the weight of the step. */
void
MoveByStep(const Interpolator & volume, double step, PhiloxStream & random, Eigen::Array3d & place)
{
  Eigen::Array3d there = place + step * AnyDirection(random);
  volume.Reflect(there);
  if (random.Unit() < volume.Weight(volume(place), volume(there)))
  {
    place = there;
  }
}
} // namespace

Trial
RunInterpolatedShapetons(const TrialVolume &  volume,
                         double               p,
                         const WalkSettings & settings,
                         ParticlePlacement    placement,
                         std::uint64_t        seed)
{
  ParticleDiffusionOptions start; // only to place the shapetons
  start.p = p;
  start.intensityWindow = { { volume.lower, volume.upper } };
  start.shapetons = settings.shapetons;
  start.placement = placement;
  start.seed = seed;
  const auto         size = volume.image->GetLargestPossibleRegion().GetSize();
  const std::clock_t clock = std::clock();
  Trial              trial;
  trial.visits = itk::Image<std::uint32_t, 3>::New();
  trial.visits->CopyInformation(volume.image);
  trial.visits->SetRegions(volume.image->GetLargestPossibleRegion());
  trial.visits->Allocate(true);
  std::uint32_t * const   visits = trial.visits->GetBufferPointer();
  const ParticleDiffusion places(
    VolumeView(volume.image->GetBufferPointer(), { { size[0], size[1], size[2] } }), start, nullptr, visits);
  const Interpolator interpolator(volume, p);
  const double       step = StepInVoxels(volume, settings.distance);
  const unsigned int workers = NumberOfThreads();
  std::mutex         mutex;
  ParallelWorkers(workers, [&](unsigned int worker) {
    std::vector<std::uint32_t> own(volume.GetNumberOfVoxels());
    for (std::uint32_t shapeton = worker; shapeton < settings.shapetons; shapeton += workers)
    {
      PhiloxStream   random(seed, shapeton, purposeOfWalk);
      Eigen::Array3d place(places.GetPlaces(0)[shapeton], places.GetPlaces(1)[shapeton], places.GetPlaces(2)[shapeton]);
      for (std::uint64_t i = 0; i < settings.steps; ++i)
      {
        (placement == ParticlePlacement::InitialHeat ? MoveByStep : MoveByWeights)(interpolator, step, random, place);
        interpolator.Reflect(place);
        ++own[interpolator.VoxelAt(place)];
      }
    }
    const std::lock_guard<std::mutex> lock(mutex);
    std::transform(own.begin(), own.end(), visits, visits, std::plus<>());
  });
  trial.field = NormalizeVisits(trial.visits);
  trial.seconds = ProcessorSeconds(std::clock() - clock);
  return trial;
}
