#ifndef shapetonTubeBores_h
#define shapetonTubeBores_h

#include "shapetonColonVolume.h"

namespace shapeton
{
constexpr double LargestBoreRadius = 4.5; // mm

/** The middle of a long, thin piece of gas: a point each mm, LPS. */
using BoreAxis = std::vector<Eigen::Vector3d>;

/** Long, thin pieces of gas: what a ball of radius `reach` does not enter, at least `leastLength` long along its middle
 * and no wider on average than a bore of LargestBoreRadius. Both in mm. Bores may be bent. A larger reach sees wider
 * bores, and more of the gas beside their openings. */
class TubeBores
{
public:
  TubeBores(const ColonGrid & grid, std::vector<unsigned char> && gas);

  std::vector<BoreAxis>
  Find(double reach, double leastLength) const;

private:
  const ColonGrid &          m_Grid;
  std::vector<unsigned char> m_Gas;
  VoxelValues                m_SquaredDepth; ///< mm^2, of gas
};
} // namespace shapeton

#endif
