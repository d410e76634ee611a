#ifndef shapetonLumenVoxels_h
#define shapetonLumenVoxels_h

#include "shapetonColonEvidence.h"
#include "shapetonColonVolume.h"

#include <functional>
#include <optional>

namespace shapeton
{
/** What a voxel of the working volume holds. */
enum LumenClass : unsigned char
{
  Nothing = 0,
  ColonGas = 1,
  ColonFluid = 2,
  OtherGas = 3,
  OtherBright = 4,
  Undecided = 5 ///< bright, and joined to the colon's fluid, perhaps by a leak
};

using ClassVolume = std::vector<unsigned char>;

/** Of a LumenClass. */
inline bool
IsColonLumen(unsigned char c)
{
  return c == ColonGas || c == ColonFluid;
}

/** Grows the first four classes at the same pace, by faces, `layers` times at most, into voxels where `mayEnter(voxel,
 * class)` holds. Where two arrive at once the colon's are served first. */
void
GrowClasses(const ColonGrid &                                               grid,
            ClassVolume &                                                   classes,
            int                                                             layers,
            const std::function<bool(std::size_t voxel, unsigned char c)> & mayEnter);

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

  ColonEvidence & evidence;
  VoxelBox        box;
  ColonGrid       grid;
  VoxelValues     hu;
  ClassVolume     classes;
  GravitySteps    fall;
};

/** The voxels of the lumen in the part of the volume around it. */
struct LumenVoxels
{
  ColonGrid          grid;
  VoxelValues        hu;
  ClassVolume        classes;
  std::vector<Level> levels; ///< of the colon; floors are voxels of `grid`

  std::optional<RectalCatheter> catheter;
};

/** Decides voxel by voxel. Takes the intensities out of `evidence` to save memory, and marks there the pieces of gas
 * that turn out to be colon because they lie over its fluid. */
LumenVoxels
DecideVoxels(const ColonImage * image, ColonEvidence & evidence);
} // namespace shapeton

#endif
