#ifndef shapetonShownVolume_h
#define shapetonShownVolume_h

#include "shapetonCoarseHeat.h"

#include <array>
#include <cstdint>
#include <vector>

namespace shapeton
{
using HeatBins = std::vector<std::uint16_t>;

/** \class ShownVolume
 * \brief The volume that a session shows, as bins of HeatHistogram. It refers to the values and does not copy them. */
class ShownVolume
{
public:
  /** Visits in units of `greatest`. */
  ShownVolume(const std::array<std::size_t, 3> & size, const std::uint32_t * visits, std::uint32_t greatest);
  ShownVolume(const std::array<std::size_t, 3> & size, const float * heat);
  ShownVolume(const std::array<std::size_t, 3> & size, const BlockValues & heat);

  /** Bins of blocks of `stride`^3 voxels: of the mean number of visits, or of the heat at the center. */
  HeatBins
  Reduced(std::size_t stride) const;

  /** Bins of the voxels with index `at` along `axis`; the lower one of the other axes is fastest. */
  HeatBins
  Slice(unsigned int axis, std::size_t at) const;

  /** The values of all voxels, in [0, 1]. */
  std::vector<float>
  Values() const;

  /** The value of a voxel, in [0, 1]. */
  float
  GetValue(std::size_t x, std::size_t y, std::size_t z) const;

private:
  HeatBins
  ReducedVisits(std::size_t stride) const;

  std::array<std::size_t, 3> m_Size;
  const std::uint32_t *      m_Visits{ nullptr };
  double                     m_Scale{ 0.0 }; ///< density of one visit
  const float *              m_Heat{ nullptr };
  const BlockValues *        m_Blocks{ nullptr };
};

/** The size of the grid of blocks of `stride`^3 voxels. */
std::array<std::size_t, 3>
ReducedSize(const std::array<std::size_t, 3> & size, std::size_t stride);
} // namespace shapeton

#endif
