#ifndef shapetonLumenField_h
#define shapetonLumenField_h

#include "shapetonColonSearch.h"

namespace shapeton
{
/** The part of the volume around the colon while its voxels are decided. The evidence stays that of the whole volume.
 */
struct LumenField
{
  /** Takes the intensities out of `evidence` to save memory. */
  explicit LumenField(ColonEvidence & colonEvidence);

  /** Gives the voxels of a run of the whole volume a class. */
  void
  Fill(const VoxelRun & run, int j, int k, unsigned char voxelClass);

  /** Voxel of this part; false where a voxel of the whole volume lies outside. */
  bool
  Local(std::size_t whole, std::array<int, 3> & v) const;

  /** The voxel t steps below v, or -1 beyond the grid. */
  std::ptrdiff_t
  Below(const std::array<int, 3> & v, int t) const;

  /** From the last voxel of gas down to fluid under a level, mm: three coarse voxels, two of which lie in the rise. */
  double
  FluidReach() const;

  /** Whether a level is one of tagged fluid. */
  bool
  IsTagged(const Level & level) const
  {
    return level.IsTagged(evidence.thresholds.tissue);
  }

  /** Whether most columns under a level end in the colon's fluid. */
  bool
  LiesOnColonFluid(const Level & level) const;

  /** Levels between the colon's gas and its fluid. */
  std::vector<Level>
  ColonLevels() const;

  ColonEvidence &    evidence;
  VoxelBox           box;
  ColonGrid          grid;
  std::vector<float> hu;
  ClassVolume        classes;
  Fall               fall;
};
} // namespace shapeton

#endif
