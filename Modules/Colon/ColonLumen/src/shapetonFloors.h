#ifndef shapetonFloors_h
#define shapetonFloors_h

#include "shapetonColonLumenSegmentation.h"
#include "shapetonFall.h"
#include "shapetonVoxelRuns.h"

namespace shapeton
{
/** Where the gas ends downwards. */
struct Floor
{
  std::size_t voxel; ///< the last one of the gas
  int         gas;   ///< its piece
  float       depth; ///< of the half-height, along gravity, mm
};

/** The floors of all gas for whose piece `use` holds. */
std::vector<Floor>
FloorsOfGas(const ColonGrid &          grid,
            const std::vector<float> & hu,
            const VoxelRuns &          gas,
            const RunLabels &          pieces,
            const std::vector<char> &  use,
            const Fall &               fall,
            const ColonThresholds &    thresholds);
} // namespace shapeton

#endif
