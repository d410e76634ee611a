#ifndef shapetonTubeBores_h
#define shapetonTubeBores_h

#include "shapetonColonVolume.h"

namespace shapeton
{
constexpr double LargestBoreRadius = 4.5; // mm; chosen: the only measured catheter has 2.5

/** Centerline of a long, thin piece of gas: one point per mm, LPS. */
using BoreAxis = std::vector<Eigen::Vector3d>;

/** Finds long, thin pieces of gas: the residue of the morphological opening by a ball of radius `reach` (mm), with a
 * centerline of at least `leastLength` (mm) and a mean cross-section no larger than that of a bore of
 * LargestBoreRadius. Bores may be bent. A larger reach finds wider bores, but includes more of the gas next to their
 * openings. */
class TubeBores
{
public:
  TubeBores(const ColonGrid & grid, std::vector<unsigned char> && gas);

  std::vector<BoreAxis>
  Find(double reach, double leastLength) const;

private:
  const ColonGrid &          m_Grid;
  std::vector<unsigned char> m_Gas;
  VoxelValues                m_SquaredDepth; ///< of gas, mm^2
};
} // namespace shapeton

#endif
