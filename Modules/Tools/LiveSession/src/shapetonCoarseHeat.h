#ifndef shapetonCoarseHeat_h
#define shapetonCoarseHeat_h

#include "ShapetonLiveSessionExport.h"
#include "shapetonCumulativeHeatDiffusion.h"

#include <array>
#include <cstdint>
#include <vector>

namespace shapeton
{
/** Values on a grid of blocks of `factor`^3 voxels, x fastest. */
struct BlockValues
{
  std::size_t                factor{ 1 };
  std::array<std::size_t, 3> size{};
  std::vector<float>         values;

  /** The blocks as a volume; `spacing` is that of the voxels. */
  VolumeView
  View(std::array<double, 3> spacing) const;
};

/** The means of the values of a volume over blocks of 2^3 voxels. */
BlockValues
Halved(const VolumeView & volume);

/** \class CoarseHeat
 * \brief A fast approximation of cumulative heat diffusion, computed on averages over blocks.
 *
 * The initial heat is computed on the volume and averaged, so that a closed object converges to its heat; t steps of
 * the volume are t / f^2 steps on blocks of f^3 voxels. */
class ShapetonLiveSession_EXPORT CoarseHeat
{
public:
  /** Averages the intensities and the initial heat of the volume. Throws as VolumeGradientOperator. */
  CoarseHeat(const VolumeView & volume, const CumulativeHeatDiffusionOptions & options);

  /** The heat after `timeSteps` on the finest grid that takes about a second on two CPU cores. */
  BlockValues
  After(std::uint64_t timeSteps, const Progress & progress = {}) const;

private:
  struct Level
  {
    BlockValues intensities;
    BlockValues heat;
    BlockValues domain; ///< share of the domain of the volume; empty if it is the whole volume
  };

  const Level &
  ChooseLevel(std::uint64_t timeSteps) const;

  std::array<double, 3>          m_Spacing;
  CumulativeHeatDiffusionOptions m_Options; ///< with the window, without smoothing
  std::vector<Level>             m_Levels;  ///< blocks of 2^3, 4^3, ... voxels
};
} // namespace shapeton

#endif
