#ifndef shapetonParticleTestRuns_h
#define shapetonParticleTestRuns_h

#include "shapetonDiffusionTestVolumes.h"
#include "shapetonParticleDiffusion.h"

#include <array>
#include <numeric>
#include <tuple>
#include <vector>

namespace shapeton
{
namespace test
{
inline ParticleDiffusionOptions
MakeSettings(const Volume & volume, std::uint32_t shapetons, double distance, double p = 7.0)
{
  ParticleDiffusionOptions settings;
  settings.p = p;
  settings.intensityWindow = volume.Window();
  settings.shapetons = shapetons;
  settings.distance = distance;
  return settings;
}

/** Shapetons in a volume, and their visits. */
class ParticleRun
{
public:
  ParticleRun(const Volume &                     volume,
              const ParticleDiffusionOptions &   settings,
              const std::vector<unsigned char> & mask = {})
    : visits(volume.values.size(), 99)
    , diffusion(volume, settings, mask.empty() ? nullptr : mask.data(), visits.data())
    , m_Size(volume.size)
    , m_Number(settings.shapetons)
  {}

  std::uint64_t
  SumOfVisits() const
  {
    return std::accumulate(visits.begin(), visits.end(), std::uint64_t{ 0 });
  }

  std::array<double, 3>
  PlaceOf(std::size_t shapeton) const
  {
    return { diffusion.GetPlaces(0)[shapeton], diffusion.GetPlaces(1)[shapeton], diffusion.GetPlaces(2)[shapeton] };
  }

  std::size_t
  VoxelOf(std::size_t shapeton) const
  {
    const auto place = this->PlaceOf(shapeton);
    const auto index = [&](unsigned int axis) { return static_cast<std::size_t>(place[axis]); };
    return (index(2) * m_Size[1] + index(1)) * m_Size[0] + index(0);
  }

  /** The number of shapetons in each voxel. */
  std::vector<std::uint64_t>
  CountByVoxel() const
  {
    std::vector<std::uint64_t> counts(visits.size(), 0);
    for (std::size_t i = 0; i < m_Number; ++i)
    {
      ++counts.at(this->VoxelOf(i));
    }
    return counts;
  }

  std::array<std::vector<float>, 3>
  Places() const
  {
    std::array<std::vector<float>, 3> places;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      places[axis].assign(diffusion.GetPlaces(axis), diffusion.GetPlaces(axis) + m_Number);
    }
    return places;
  }

  std::vector<std::uint32_t> visits;
  ParticleDiffusion          diffusion;

private:
  Size        m_Size;
  std::size_t m_Number;
};

/** All measures, for comparison. */
inline auto
Tied(const ParticleMeasures & measures)
{
  return std::tie(measures.step,
                  measures.maximumVisits,
                  measures.voxelsReached,
                  measures.objectVoxels,
                  measures.objectVoxelsReached,
                  measures.trappedShapetons,
                  measures.change,
                  measures.automaticEpsilon,
                  measures.steady);
}
} // namespace test
} // namespace shapeton

#endif
