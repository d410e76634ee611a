#ifndef itkFloors_h
#define itkFloors_h

#include "itkColonLumenSegmentation.h"
#include "itkFall.h"
#include "itkRuns.h"

namespace itk
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
            const RunSet &             gas,
            const RunLabels &          pieces,
            const std::vector<char> &  use,
            const Fall &               fall,
            const ColonThresholds &    thresholds);
} // namespace itk

#endif
