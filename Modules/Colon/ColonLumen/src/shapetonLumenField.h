#ifndef shapetonLumenField_h
#define shapetonLumenField_h

#include "shapetonColonEvidence.h"
#include "shapetonColonVolume.h"

#include <functional>

namespace shapeton
{
/** Class of a voxel of the working volume. */
enum LumenClass : unsigned char
{
  Nothing = 0,
  ColonGas = 1,
  ColonFluid = 2,
  OtherGas = 3,
  OtherBright = 4,
  Undecided = 5 ///< bright and connected to the fluid of the colon, possibly through a leak
};

using ClassVolume = std::vector<unsigned char>;

/** Whether a LumenClass is lumen. */
inline bool
IsColonLumen(unsigned char c)
{
  return c == ColonGas || c == ColonFluid;
}

/** Grows the first four classes at the same rate over voxel faces, by at most `layers`, into voxels where
 * `mayEnter(voxel, class)` is true. The colon has priority in ties. */
void
GrowClasses(const ColonGrid &                                               grid,
            ClassVolume &                                                   classes,
            int                                                             layers,
            const std::function<bool(std::size_t voxel, unsigned char c)> & mayEnter);

/** The part of the volume around the colon during voxel classification. The evidence refers to the whole volume. */
struct LumenField
{
  /** Moves the intensities from `evidence` to save memory. */
  explicit LumenField(ColonEvidence & colonEvidence);

  /** Sets the class of the voxels in a run of the whole volume. */
  void
  Fill(const VoxelRun & run, int j, int k, unsigned char voxelClass);

  /** Converts a voxel of the whole volume to this part; returns false if it is outside. */
  bool
  Local(std::size_t whole, std::array<int, 3> & v) const;

  /** The voxel t steps below v, or -1 outside the grid. */
  std::ptrdiff_t
  Below(const std::array<int, 3> & v, int t) const;

  /** Search distance (mm) from the lowest gas voxel down to fluid; at least three voxels, since two coarse voxels may
   * be in the rise. */
  double
  FluidReach() const;

  /** Standard deviation (mm) of the blur of a step along gravity, including the effect of voxel size. */
  double
  Blur() const;

  /** Whether a level is the surface of tagged fluid. */
  bool
  IsTagged(const Level & level) const
  {
    return level.IsTagged(evidence.thresholds.tissue);
  }

  /** Whether most columns under a level end in the fluid of the colon. */
  bool
  LiesOnColonFluid(const Level & level) const;

  /** Levels between the gas of the colon and its fluid. */
  std::vector<Level>
  ColonLevels() const;

  ColonEvidence & evidence;
  VoxelBox        box;
  ColonGrid       grid;
  VoxelValues     hu;
  ClassVolume     classes;
  GravitySteps    fall;
};
} // namespace shapeton

#endif
