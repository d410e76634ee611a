#ifndef shapetonDeviceShapetonWalk_h
#define shapetonDeviceShapetonWalk_h

#include "shapetonShapetonKernels.h"
#include "shapetonShapetonTally.h"

#include <cstddef>

namespace shapeton
{
/** Parameters of a walk for the GPU plug-in; all memory is on the host. */
struct DeviceShapetonSettings
{
  ShapetonKernels::Surroundings       surroundings;
  const ShapetonKernels::ThetaTable * table;
  ShapetonKernels::Sampling           sampling;
  bool                                traversal;
  std::size_t                         shapetons;
  std::uint64_t                       seed;
};

/** Positions and visits of the shapetons. */
struct ShapetonArrays
{
  float *         places[3];
  std::uint32_t * voxels;
  std::uint32_t * visits;
};

/** \class DeviceShapetonWalk
 * \brief Shapetons in GPU memory, equivalent to ShapetonWalk on the CPU. */
class DeviceShapetonWalk
{
public:
  DeviceShapetonWalk() = default;
  DeviceShapetonWalk(const DeviceShapetonWalk &) = delete;
  DeviceShapetonWalk &
  operator=(const DeviceShapetonWalk &) = delete;
  virtual ~DeviceShapetonWalk() = default;

  virtual void
  Upload(const ShapetonArrays & host) = 0;
  virtual void
  Download(const ShapetonArrays & host) const = 0;
  virtual ShapetonTally
  TakeSteps(std::size_t first, std::size_t number, std::uint64_t begin, std::uint64_t end) = 0;
  virtual ShapetonSum
  SumOverShapetons() = 0;
};

/** Type of the plug-in's function ShapetonMakeWalk(). */
using MakeDeviceShapetonWalkFunction = DeviceShapetonWalk *(const DeviceShapetonSettings & settings);
} // namespace shapeton

#endif
