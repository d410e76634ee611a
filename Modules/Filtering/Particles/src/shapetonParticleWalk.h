#ifndef shapetonParticleWalk_h
#define shapetonParticleWalk_h

#include "shapetonDeviceParticleWalk.h"
#include "shapetonParticleDiffusion.h"
#include "shapetonParticleKernels.h"
#include "shapetonParticleRecords.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace shapeton
{
/** The shapetons of a run in their volume: positions, motion, and visit counts. */
struct ParticleWalk
{
  /** Places the shapetons; see ParticleDiffusion. */
  ParticleWalk(const EdgeVolume &               edges,
               const ParticleDiffusionOptions & given,
               const unsigned char *            mask,
               std::uint32_t *                  visitsOfVoxels,
               const std::function<void()> &    poll);

  std::size_t
  NumberOfVoxels() const
  {
    return size[0] * size[1] * size[2];
  }

  /** Steps [begin, end) of shapetons [first, first + number). */
  ParticleTally
  TakeSteps(std::size_t first, std::size_t number, std::uint64_t begin, std::uint64_t end);

  ParticleSum
  SumOverShapetons();

  /** Transfers positions, voxels and visits to and from a GPU. */
  void
  FetchFromDevice();
  void
  SendToDevice();

  const ParticleDiffusionOptions      settings;
  const std::array<double, 2>         window;
  const std::array<std::size_t, 3>    size;
  const std::array<double, 3>         spacing;
  std::uint32_t * const               visits;
  const ParticleKernels::Set &        kernels;
  const ParticleKernels::ThetaTable & table;
  const ParticleRecords               records;
  ParticleKernels::Surroundings       surroundings{};
  std::array<std::vector<float>, 3>   places; ///< in voxels, in the layout of the kernels
  std::vector<std::uint32_t>          voxels;
  DeviceUse                           deviceUse;

private:
  void
  ChooseDevice();
  void
  DescribeSurroundings();
  void
  Place(const unsigned char * mask);
  ParticleKernels::Shapetons
  Group(std::size_t first, std::size_t number);
  /** One step of a group: directions, then moves. */
  void
  Move(const ParticleKernels::Shapetons & group, std::uint64_t step) const;
  template <bool VShared>
  ParticleTally
  Count(const ParticleKernels::Shapetons & group) const;
  template <typename TBody>
  void
  ForGroups(std::size_t first, std::size_t number, std::uint64_t shapetonSteps, const TBody & body);

  std::unique_ptr<DeviceParticleWalk> m_Device;
};
} // namespace shapeton

#endif
