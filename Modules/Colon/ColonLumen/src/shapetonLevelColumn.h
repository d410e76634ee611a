#ifndef shapetonLevelColumn_h
#define shapetonLevelColumn_h

#include "shapetonColonLumenSegmentation.h"
#include "shapetonLevels.h"

namespace shapeton
{
/** Columns along gravity, from a level down to bright matter.
 *
 * Below a level values rise as the blur has it, and stay. Where they lag behind that rise, or fall again before the
 * bright matter is reached, a wall lies in between: what is bright there is another bowel. */
class LevelColumn
{
public:
  /** Columns from levels to one piece of bright matter. */
  struct Votes
  {
    std::size_t open{ 0 };
    std::size_t all{ 0 };

    /** Noise opens some columns through a wall, and closes some that are open. */
    bool
    AreOpen() const
    {
      return 3 * open > 2 * all;
    }
  };

  /** `noise`: standard deviation in HU; `smoothing`: sigma of the prefilter in mm. */
  LevelColumn(const ColonGrid &          grid,
              const std::vector<float> & hu,
              const Fall &               fall,
              const ColonThresholds &    thresholds,
              double                     noise,
              double                     smoothing);

  /** Whether no wall shows between the level and the voxel `steps` below one of its floors; both on the grid. */
  bool
  IsOpen(const Level & level, const std::array<int, 3> & floor, int steps) const;

private:
  const ColonGrid &          m_Grid;
  const std::vector<float> & m_Hu;
  const Fall &               m_Fall;
  const ColonThresholds &    m_Thresholds;
  double                     m_Noise;
  double                     m_Blur; ///< mm, voxels included
};
} // namespace shapeton

#endif
