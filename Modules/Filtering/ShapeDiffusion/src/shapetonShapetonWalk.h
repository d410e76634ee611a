#ifndef shapetonShapetonWalk_h
#define shapetonShapetonWalk_h

#include "shapetonDeviceShapetonWalk.h"
#include "shapetonShapetonDiffusion.h"
#include "shapetonShapetonKernels.h"
#include "shapetonShapetonRecords.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace shapeton
{
/** The shapetons of a run in their volume: positions, motion, and visit counts. */
struct ShapetonWalk
{
  /** Places the shapetons; see ShapetonDiffusion. */
  ShapetonWalk(const float *                      intensities,
               const std::array<std::size_t, 3> & volumeSize,
               const ShapetonDiffusionSettings &  given,
               const unsigned char *              mask,
               std::uint32_t *                    visitsOfVoxels,
               const std::function<void()> &      poll);

  std::size_t
  NumberOfVoxels() const
  {
    return size[0] * size[1] * size[2];
  }

  /** Steps [begin, end) of shapetons [first, first + number). */
  ShapetonTally
  TakeSteps(std::size_t first, std::size_t number, std::uint64_t begin, std::uint64_t end);

  ShapetonSum
  SumOverShapetons();

  /** For a GPU that moves the shapetons: transfers positions, voxels and visits. */
  void
  FetchFromDevice();
  void
  SendToDevice();

  const ShapetonDiffusionSettings     settings;
  const std::array<std::size_t, 3>    size;
  std::uint32_t * const               visits;
  const ShapetonKernels::Set &        kernels;
  const ShapetonKernels::ThetaTable & table;
  const ShapetonRecords               records;
  ShapetonKernels::Surroundings       surroundings{};
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
  ShapetonKernels::Shapetons
  Group(std::size_t first, std::size_t number);
  /** One step of a group: directions, then moves. */
  void
  Move(const ShapetonKernels::Shapetons & group, std::uint64_t step) const;
  template <bool VShared>
  ShapetonTally
  Count(const ShapetonKernels::Shapetons & group) const;
  template <typename TBody>
  void
  ForGroups(std::size_t first, std::size_t number, std::uint64_t shapetonSteps, const TBody & body);

  std::unique_ptr<DeviceShapetonWalk> m_Device;
};
} // namespace shapeton

#endif
