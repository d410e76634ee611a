#include "shapetonFluidNecks.h"

#include "shapetonLevelColumn.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double PassageRadius = 2.5;   // mm; what joins two parts of the fluid more narrowly is a leak
constexpr double PassageInVoxels = 1.4; // the least radius of a passage: a layer of voxels that a wall crosses is none
constexpr double ThinReach = 12.0;      // mm from wide fluid, or from a level, to the end of a thin layer
constexpr double DeepestWide = 20.0;    // mm from a level down to a wide part

/** The parts of the undecided matter that are as wide as a passage, and which of them are the colon's. */
class WideFluid
{
public:
  explicit WideFluid(LumenField & field)
    : m_Field(field)
    , m_Column(field.grid,
               field.hu,
               field.fall,
               field.evidence.thresholds,
               field.evidence.remainingNoise,
               field.evidence.smoothing)
  {
    const ClassVolume &        classes = field.classes;
    std::vector<unsigned char> mask(classes.size());
    std::transform(classes.begin(), classes.end(), mask.begin(), [](unsigned char c) { return c == Undecided; });
    const auto   d = SquaredDistanceToBackground(field.grid, mask);
    const double radius = std::max(PassageRadius, PassageInVoxels * field.grid.spacing.maxCoeff());
    m_Runs = CollectRuns(field.grid, [&](std::size_t p) { return d[p] >= radius * radius && classes[p] == Undecided; });
    m_Labels = LabelRuns(m_Runs);
    m_IsColon.assign(m_Labels.number + 1, 0);
  }

  /** Marks the fluid right under the colon's levels, and the wide parts of it that columns from there reach without a
   * wall in between. */
  void
  MarkUnderLevels()
  {
    std::vector<LevelColumn::Votes> votes(m_IsColon.size());
    for (const auto & level : m_Field.evidence.levels)
    {
      std::array<int, 3> v;
      for (const auto floor : level.floors)
      {
        if (m_Field.evidence.isColon[level.gas] && m_Field.IsTagged(level) && m_Field.Local(floor, v))
        {
          this->MarkColumn(level, v, votes);
        }
      }
    }
    for (std::size_t n = 1; n < votes.size(); ++n)
    {
      m_IsColon[n] = m_IsColon[n] || (votes[n].all > 0 && votes[n].AreOpen());
    }
  }

  void
  MarkSeeds()
  {
    for (const auto & seed : m_Field.evidence.brightSeeds)
    {
      std::array<int, 3> v;
      if (m_Field.Local(m_Field.evidence.grid.Index(seed[0], seed[1], seed[2]), v))
      {
        m_Field.classes[m_Field.grid.Index(v[0], v[1], v[2])] = ColonFluid;
        const auto run = m_Runs.Find(v[0], v[1], v[2]);
        m_IsColon[run < 0 ? 0 : m_Labels.ofRun[run]] = 1;
      }
    }
  }

  void
  Paint()
  {
    ForEachRun(m_Runs, [&](std::size_t r, int j, int k) {
      const auto first = m_Field.classes.begin() + m_Field.grid.Index(0, j, k);
      std::fill(first + m_Runs.runs[r].begin,
                first + m_Runs.runs[r].end,
                m_IsColon[m_Labels.ofRun[r]] ? ColonFluid : OtherBright);
    });
  }

private:
  /** One column under a level: its first fluid, and a vote on the first wide part below. */
  void
  MarkColumn(const Level & level, const std::array<int, 3> & floor, std::vector<LevelColumn::Votes> & votes)
  {
    bool isIn = false;
    bool isOpen = false;
    for (int t = 1; t * m_Field.fall.step <= (isIn ? DeepestWide : m_Field.FluidReach()); ++t)
    {
      const auto q = m_Field.Below(floor, t);
      if (q < 0)
      {
        return;
      }
      unsigned char & here = m_Field.classes[q];
      const bool      isFluid = here == Undecided || here == ColonFluid;
      if (isIn && !isFluid)
      {
        return;
      }
      if (!isIn && isFluid)
      {
        isIn = true;
        isOpen = m_Column.IsOpen(level, floor, t);
        here = isOpen ? static_cast<unsigned char>(ColonFluid) : here;
      }
      const auto w = m_Field.grid.Voxel(q);
      const auto run = m_Runs.Find(w[0], w[1], w[2]);
      if (isIn && run >= 0)
      {
        votes[m_Labels.ofRun[run]].open += isOpen;
        ++votes[m_Labels.ofRun[run]].all;
        return;
      }
    }
  }

  LumenField &      m_Field;
  LevelColumn       m_Column;
  VoxelRuns         m_Runs;
  RunLabels         m_Labels;
  std::vector<char> m_IsColon; ///< by label
};
} // namespace

void
SplitAtNecks(LumenField & field)
{
  WideFluid wide(field);
  wide.MarkUnderLevels();
  wide.MarkSeeds();
  wide.Paint();
  ClassVolume & classes = field.classes;
  const int     layers = static_cast<int>(std::ceil(ThinReach / std::cbrt(field.grid.VoxelVolume())));
  GrowClasses(field.grid, classes, layers, [&classes](std::size_t p, unsigned char c) {
    return classes[p] == Undecided && (c == ColonFluid || c == OtherBright);
  });
  std::replace(
    classes.begin(), classes.end(), static_cast<unsigned char>(Undecided), static_cast<unsigned char>(OtherBright));
}
} // namespace shapeton
