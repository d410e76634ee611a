#ifndef shapetonDeviceParticleWalk_h
#define shapetonDeviceParticleWalk_h

#include "shapetonParticleKernels.h"
#include "shapetonParticleTally.h"

#include <cstddef>

namespace shapeton
{
/** Parameters of a walk for the GPU plug-in; all memory is on the host. */
struct DeviceParticleSettings
{
  ParticleKernels::Surroundings       surroundings;
  const ParticleKernels::ThetaTable * table;
  ParticleKernels::Sampling           sampling;
  bool                                traversal;
  std::size_t                         shapetons;
  std::uint64_t                       seed;
};

/** Positions and visits of the shapetons. */
struct ParticleArrays
{
  float *         places[3];
  std::uint32_t * voxels;
  std::uint32_t * visits;
};

/** \class DeviceParticleWalk
 * \brief Shapetons in GPU memory, equivalent to ParticleWalk on the CPU. */
class DeviceParticleWalk
{
public:
  DeviceParticleWalk() = default;
  DeviceParticleWalk(const DeviceParticleWalk &) = delete;
  DeviceParticleWalk &
  operator=(const DeviceParticleWalk &) = delete;
  virtual ~DeviceParticleWalk() = default;

  virtual void
  Upload(const ParticleArrays & host) = 0;
  virtual void
  Download(const ParticleArrays & host) const = 0;
  virtual ParticleTally
  TakeSteps(std::size_t first, std::size_t number, std::uint64_t begin, std::uint64_t end) = 0;
  virtual ParticleSum
  SumOverShapetons() = 0;
};

/** Type of the plug-in's function ShapetonMakeWalk(). */
using MakeDeviceParticleWalkFunction = DeviceParticleWalk *(const DeviceParticleSettings & settings);
} // namespace shapeton

#endif
