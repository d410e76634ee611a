#ifndef shapetonTubeBores_h
#define shapetonTubeBores_h

#include "shapetonColonVolume.h"

namespace shapeton
{
constexpr double LargestBoreRadius = 4.5; // mm

/** Centerline of a long, thin piece of gas: one point per mm, LPS. */
using BoreAxis = std::vector<Eigen::Vector3d>;

/** Finds long, thin pieces of gas: the part not reached by a ball of radius `reach`, at least `leastLength` long along
 * its centerline and on average no wider than a bore of LargestBoreRadius. Both in mm. Bores may be bent. A larger
 * reach finds wider bores, and more of the gas next to their openings. */
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
