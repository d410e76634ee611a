#include "itkLumenVoxels.h"

#include "itkDistanceToBackground.h"
#include "itkCatheter.h"
#include "itkLevelColumn.h"
#include "itkLocalFluid.h"
#include "itkUnmixedFluid.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace itk
{
namespace
{
constexpr double PassageRadius = 2.5;   // mm; what joins two parts of the fluid more narrowly is a leak
constexpr double PassageInVoxels = 1.4; // the least radius of a passage: a layer of voxels that a wall crosses is none
constexpr double ThinReach = 12.0;      // mm from wide fluid, or from a level, to the end of a thin layer
constexpr double GrowthReach = 3.0;     // mm
constexpr double LeastBrightMl = 0.05;  // of other bright matter that competes
constexpr double LevelReach = 6.0;      // mm around the flat part of a level
constexpr double UsualBlur = 0.8;       // mm, standard deviation of the scanner's
constexpr double LevelLeeway = 0.5;     // mm
constexpr double FilledCavityMl = 0.03;

/** Takes ColonEvidence to classes, step by step. */
class VoxelDecision
{
public:
  VoxelDecision(const ColonImage * image, ColonEvidence & evidence)
    : m_Image(image)
    , m_Evidence(evidence)
    , m_Box(BoxOfColon(evidence))
    , m_Grid(evidence.grid.Part(m_Box))
    , m_Hu(CropVoxels(evidence.hu, evidence.grid, m_Box))
    , m_Classes(m_Grid.NumberOfVoxels(), Nothing)
    , m_Fall(m_Grid, evidence.gravity)
    , m_Column(m_Grid, m_Hu, m_Fall, evidence.thresholds, evidence.remainingNoise, evidence.smoothing)
    , m_Layers(std::max(2, static_cast<int>(std::lround(GrowthReach / std::cbrt(m_Grid.VoxelVolume())))))
  {
    std::vector<float>().swap(evidence.hu);
  }

  LumenVoxels
  Decide()
  {
    this->PaintGas();
    this->PaintBright();
    this->SplitAtNecks();
    while (this->TakeGasOverFluid() && this->TakeBrightUnderGas())
    {
      this->SplitAtNecks();
    }
    this->Grow();
    this->AddUnmixed();
    this->FillLevels();
    this->FillCavities();
    FillCatheter(m_Grid, m_Hu, m_Evidence.thresholds.gasBoundary, m_Classes);
    auto levels = this->ColonLevels();
    return { m_Grid, std::move(m_Hu), std::move(m_Classes), std::move(levels) };
  }

private:
  /** The part of a run inside the box as a range of voxels; empty where it lies outside. */
  std::array<std::size_t, 2>
  Range(const Run & run, int j, int k) const
  {
    const int begin = std::max(run.begin, m_Box.low[0]);
    const int end = std::min(run.end, m_Box.high[0]);
    if (begin >= end || j < m_Box.low[1] || j >= m_Box.high[1] || k < m_Box.low[2] || k >= m_Box.high[2])
    {
      return { { 0, 0 } };
    }
    const auto first = m_Grid.Index(begin - m_Box.low[0], j - m_Box.low[1], k - m_Box.low[2]);
    return { { first, first + end - begin } };
  }

  void
  Paint(const RunSet & set, const std::function<unsigned char(std::size_t run)> & classOf)
  {
    ForEachRun(set, [&](std::size_t r, int j, int k) {
      const auto range = this->Range(set.runs[r], j, k);
      std::fill(m_Classes.begin() + range[0], m_Classes.begin() + range[1], range[0] < range[1] ? classOf(r) : 0);
    });
  }

  void
  PaintGas()
  {
    this->Paint(m_Evidence.gas.set, [this](std::size_t r) -> unsigned char {
      const int piece = m_Evidence.gas.labels.ofRun[r];
      return m_Evidence.isColon[piece] ? ColonGas : OtherGas;
    });
  }

  void
  PaintBright()
  {
    std::vector<std::size_t> voxels(m_Evidence.brightLabels.number + 1, 0);
    for (std::size_t r = 0; r < m_Evidence.brightSet.runs.size(); ++r)
    {
      voxels[m_Evidence.brightLabels.ofRun[r]] += m_Evidence.brightSet.runs[r].end - m_Evidence.brightSet.runs[r].begin;
    }
    this->Paint(m_Evidence.brightSet, [&](std::size_t r) -> unsigned char {
      const int piece = m_Evidence.brightLabels.ofRun[r];
      if (m_Evidence.isColonBright[piece])
      {
        return Undecided;
      }
      return voxels[piece] * m_Grid.VoxelVolume() * 1e-3 >= LeastBrightMl ? OtherBright : Nothing;
    });
  }

  /** Voxel of this box; false where a voxel of the whole grid lies outside. */
  bool
  Local(std::size_t whole, std::array<int, 3> & v) const
  {
    v = m_Evidence.grid.Voxel(whole);
    for (int a = 0; a < 3; ++a)
    {
      v[a] -= m_Box.low[a];
    }
    return m_Grid.Holds(v[0], v[1], v[2]);
  }

  /** The voxel t steps below v, or -1 beyond the grid. */
  std::ptrdiff_t
  Below(const std::array<int, 3> & v, int t) const
  {
    const auto o = m_Fall.Offset(t);
    return m_Grid.Holds(v[0] + o[0], v[1] + o[1], v[2] + o[2])
             ? static_cast<std::ptrdiff_t>(m_Grid.Index(v[0] + o[0], v[1] + o[1], v[2] + o[2]))
             : -1;
  }

  /** Marks the fluid right under the colon's levels, and the wide parts of it that columns from there reach without a
   * wall in between. */
  void
  MarkUnderLevels(const RunSet & wide, const RunLabels & wideLabels, std::vector<char> & isColonWide)
  {
    const double                    tissue = m_Evidence.thresholds.tissue;
    std::vector<LevelColumn::Votes> votes(isColonWide.size());
    for (const auto & level : m_Evidence.levels)
    {
      std::array<int, 3> v;
      for (const auto floor : level.floors)
      {
        if (m_Evidence.isColon[level.gas] && level.IsTagged(tissue) && this->Local(floor, v))
        {
          this->MarkColumn(level, v, wide, wideLabels, votes);
        }
      }
    }
    for (std::size_t n = 1; n < votes.size(); ++n)
    {
      isColonWide[n] = isColonWide[n] || (votes[n].all > 0 && votes[n].AreOpen());
    }
  }

  /** From the last voxel of gas down to fluid under a level, mm: three coarse voxels, two of which lie in the rise. */
  double
  FluidReach() const
  {
    return std::max(5.0, StepsToFluid * m_Fall.step);
  }

  /** One column under a level: its first fluid, and a vote on the first wide part below. */
  void
  MarkColumn(const Level &                     level,
             const std::array<int, 3> &        floor,
             const RunSet &                    wide,
             const RunLabels &                 wideLabels,
             std::vector<LevelColumn::Votes> & votes)
  {
    bool isIn = false;
    bool isOpen = false;
    for (int t = 1; t * m_Fall.step <= (isIn ? 20.0 : this->FluidReach()); ++t)
    {
      const auto q = this->Below(floor, t);
      if (q < 0 || (isIn && m_Classes[q] != Undecided && m_Classes[q] != ColonFluid))
      {
        return;
      }
      if (!isIn && (m_Classes[q] == Undecided || m_Classes[q] == ColonFluid))
      {
        isIn = true;
        isOpen = m_Column.IsOpen(level, floor, t);
        m_Classes[q] = isOpen ? static_cast<unsigned char>(ColonFluid) : m_Classes[q];
      }
      const auto w = m_Grid.Voxel(q);
      const auto run = wide.Find(w[0], w[1], w[2]);
      if (isIn && run >= 0)
      {
        votes[wideLabels.ofRun[run]].open += isOpen;
        ++votes[wideLabels.ofRun[run]].all;
        return;
      }
    }
  }

  void
  MarkSeeds(const RunSet & wide, const RunLabels & wideLabels, std::vector<char> & isColonWide)
  {
    for (const auto & seed : m_Evidence.brightSeeds)
    {
      std::array<int, 3> v;
      if (this->Local(m_Evidence.grid.Index(seed[0], seed[1], seed[2]), v))
      {
        m_Classes[m_Grid.Index(v[0], v[1], v[2])] = ColonFluid;
        const auto run = wide.Find(v[0], v[1], v[2]);
        isColonWide[run < 0 ? 0 : wideLabels.ofRun[run]] = 1;
      }
    }
  }

  /** Of the bright matter joined to the colon's levels only what a wide passage reaches is colon; the rest competes for
   * what lies between. Thin matter is colon no farther than ThinReach: beyond, it is bone or another bowel. */
  void
  SplitAtNecks()
  {
    std::vector<unsigned char> mask(m_Classes.size());
    std::transform(m_Classes.begin(), m_Classes.end(), mask.begin(), [](unsigned char c) { return c == Undecided; });
    const auto   d = SquaredDistanceToBackground(m_Grid, mask);
    const double radius = std::max(PassageRadius, PassageInVoxels * m_Grid.spacing.maxCoeff());
    const RunSet wide =
      CollectRuns(m_Grid, [&](std::size_t p) { return d[p] >= radius * radius && m_Classes[p] == Undecided; });
    const RunLabels   wideLabels = LabelRuns(wide, true);
    std::vector<char> isColonWide(wideLabels.number + 1, 0);
    this->MarkUnderLevels(wide, wideLabels, isColonWide);
    this->MarkSeeds(wide, wideLabels, isColonWide);
    ForEachRun(wide, [&](std::size_t r, int j, int k) {
      const auto first = m_Grid.Index(0, j, k);
      std::fill(m_Classes.begin() + first + wide.runs[r].begin,
                m_Classes.begin() + first + wide.runs[r].end,
                isColonWide[wideLabels.ofRun[r]] ? ColonFluid : OtherBright);
    });
    const int layers = static_cast<int>(std::ceil(ThinReach / std::cbrt(m_Grid.VoxelVolume())));
    GrowClasses(m_Grid, m_Classes, layers, [this](std::size_t p, unsigned char c) {
      return m_Classes[p] == Undecided && (c == ColonFluid || c == OtherBright);
    });
    std::replace(m_Classes.begin(),
                 m_Classes.end(),
                 static_cast<unsigned char>(Undecided),
                 static_cast<unsigned char>(OtherBright));
  }

  /** Whether most columns under a level end in the colon's fluid. */
  bool
  LiesOnColonFluid(const Level & level) const
  {
    std::size_t hits = 0;
    for (const auto floor : level.floors)
    {
      std::array<int, 3> v;
      bool               isOnFluid = false;
      for (int t = 1; this->Local(floor, v) && t * m_Fall.step <= this->FluidReach() && !isOnFluid; ++t)
      {
        const auto q = this->Below(v, t);
        isOnFluid = q >= 0 && m_Classes[q] == ColonFluid;
      }
      hits += isOnFluid;
    }
    return 2 * hits > level.floors.size();
  }

  /** Pockets of gas that share a level with the colon's fluid. */
  bool
  TakeGasOverFluid()
  {
    bool found = false;
    for (const auto & level : m_Evidence.levels)
    {
      if (!m_Evidence.isColon[level.gas] && level.IsTagged(m_Evidence.thresholds.tissue) &&
          this->LiesOnColonFluid(level))
      {
        m_Evidence.isColon[level.gas] = 1;
        found = true;
      }
    }
    if (found)
    {
      ForEachRun(m_Evidence.gas.set, [&](std::size_t r, int j, int k) {
        if (m_Evidence.isColon[m_Evidence.gas.labels.ofRun[r]])
        {
          const auto range = this->Range(m_Evidence.gas.set.runs[r], j, k);
          std::fill(m_Classes.begin() + range[0], m_Classes.begin() + range[1], ColonGas);
        }
      });
    }
    return found;
  }

  /** Bright pieces under levels of gas that has become colon: to be decided like those found at first. */
  bool
  TakeBrightUnderGas()
  {
    std::vector<char> isNew(m_Evidence.isColonBright.size(), 0);
    bool              found = false;
    for (std::size_t l = 0; l < m_Evidence.levels.size(); ++l)
    {
      for (const int piece : m_Evidence.brightOfLevel[l])
      {
        if (m_Evidence.isColon[m_Evidence.levels[l].gas] && !m_Evidence.isColonBright[piece])
        {
          m_Evidence.isColonBright[piece] = 1;
          isNew[piece] = 1;
          found = true;
        }
      }
    }
    ForEachRun(m_Evidence.brightSet, [&](std::size_t r, int j, int k) {
      if (isNew[m_Evidence.brightLabels.ofRun[r]])
      {
        const auto range = this->Range(m_Evidence.brightSet.runs[r], j, k);
        std::fill(m_Classes.begin() + range[0], m_Classes.begin() + range[1], Undecided);
      }
    });
    return found;
  }

  /** Walls are looked for in the input itself: the prefilter would hide them. */
  void
  AddUnmixed()
  {
    const auto & e = m_Evidence;
    const auto   seeds = this->FaintSeeds();
    const auto   add = [&](const std::vector<float> & sharp) {
      AddUnmixedFluid(m_Grid, m_Hu, sharp, e.thresholds, e.remainingNoise, e.smoothing, seeds, m_Classes);
    };
    if (e.smoothing > 0.0)
    {
      add(LoadVoxels(m_Image, m_Grid));
    }
    else
    {
      add(m_Hu);
    }
  }

  /** Faintly tagged fluid under the colon's levels, where no surely bright matter lies. */
  std::vector<std::size_t>
  FaintSeeds() const
  {
    std::vector<std::size_t> seeds;
    const double             tissue = m_Evidence.thresholds.tissue;
    for (const auto & level : m_Evidence.levels)
    {
      std::array<int, 3> v;
      for (const auto floor : level.floors)
      {
        if (!m_Evidence.isColon[level.gas] || !level.IsTagged(tissue) || !this->Local(floor, v))
        {
          continue;
        }
        const auto q = this->Below(v, static_cast<int>(std::lround(0.5 + 2.0 / m_Fall.step)));
        if (q >= 0 && m_Classes[q] == Nothing && std::abs(m_Hu[q] - level.edge) < 0.4 * (level.edge - tissue))
        {
          seeds.push_back(q);
        }
      }
    }
    return seeds;
  }

  LocalFluid
  FluidAround() const
  {
    std::vector<unsigned char> mask(m_Classes.size());
    std::transform(m_Classes.begin(), m_Classes.end(), mask.begin(), [](unsigned char c) { return c == ColonFluid; });
    return LocalFluid(m_Grid, m_Hu, mask, m_Evidence.thresholds.fluid);
  }

  void
  Grow()
  {
    const auto &     t = m_Evidence.thresholds;
    const LocalFluid fluid = this->FluidAround();
    GrowClasses(m_Grid, m_Classes, m_Layers, [&](std::size_t p, unsigned char c) {
      if (c == ColonGas || c == OtherGas)
      {
        return m_Hu[p] < t.gasBoundary;
      }
      const auto v = m_Grid.Voxel(p);
      return t.fluid > 0.0 && m_Hu[p] > 0.5 * (t.tissue + fluid.At(v[0], v[1], v[2]));
    });
  }

  std::vector<Level>
  ColonLevels() const
  {
    std::vector<Level> levels;
    for (const auto & level : m_Evidence.levels)
    {
      if (m_Evidence.isColon[level.gas] && this->LiesOnColonFluid(level))
      {
        levels.push_back(level);
      }
    }
    return levels;
  }

  /** Fills the layer in which values pass from gas to fluid, near levels only: elsewhere a wall may lie between. */
  void
  FillLevels()
  {
    std::vector<LateralCells::Place> places;
    std::vector<float>               depths;
    for (const auto & level : this->ColonLevels())
    {
      for (const auto floor : level.floors)
      {
        const auto p = m_Evidence.grid.Position(floor);
        places.push_back({ static_cast<float>(p.dot(m_Fall.across[0])), static_cast<float>(p.dot(m_Fall.across[1])) });
        const Eigen::Vector2d d = Eigen::Vector2d(places.back().a, places.back().b) - level.centre;
        depths.push_back(static_cast<float>(level.depth + level.slope.dot(d)));
      }
    }
    const LateralCells cells(places, LevelReach);
    const int steps = static_cast<int>(std::ceil((this->LayerThickness() + 2.0 * LevelLeeway) / m_Fall.step)) + 1;
    const ClassVolume before = m_Classes;
    ParallelFor(m_Grid.size[2], [&](std::size_t k) {
      for (std::size_t p = k * m_Grid.stride[2]; p < (k + 1) * m_Grid.stride[2]; ++p)
      {
        if (before[p] == Nothing && this->IsBetween(before, p, steps) && this->IsNearLevel(p, cells, places, depths))
        {
          const double half = 0.5 * (m_Evidence.thresholds.gas + m_Evidence.thresholds.fluid);
          m_Classes[p] = m_Hu[p] < half ? ColonGas : ColonFluid;
        }
      }
    });
  }

  /** From where values leave the gas to where they reach the fluid, mm: between 31 % and 81 % of a blurred step. */
  double
  LayerThickness() const
  {
    return 1.38 * std::sqrt(UsualBlur * UsualBlur + m_Evidence.smoothing * m_Evidence.smoothing +
                            m_Fall.step * m_Fall.step / 12.0);
  }

  /** Gas above and fluid below, nothing else in between, all within some steps. */
  bool
  IsBetween(const ClassVolume & classes, std::size_t p, int steps) const
  {
    const auto v = m_Grid.Voxel(p);
    int        up = 1;
    while (up <= steps && this->Below(v, -up) >= 0 && classes[this->Below(v, -up)] == Nothing)
    {
      ++up;
    }
    int down = 1;
    while (down <= steps && this->Below(v, down) >= 0 && classes[this->Below(v, down)] == Nothing)
    {
      ++down;
    }
    return up + down <= steps + 1 && this->Below(v, -up) >= 0 && this->Below(v, down) >= 0 &&
           classes[this->Below(v, -up)] == ColonGas && classes[this->Below(v, down)] == ColonFluid;
  }

  bool
  IsNearLevel(std::size_t                              p,
              const LateralCells &                     cells,
              const std::vector<LateralCells::Place> & places,
              const std::vector<float> &               depths) const
  {
    const auto   x = m_Grid.Position(p);
    const double a = x.dot(m_Fall.across[0]);
    const double b = x.dot(m_Fall.across[1]);
    const double depth = x.dot(m_Fall.direction);
    bool         isNear = false;
    cells.ForEachNear(a, b, [&](int i) {
      const double da = places[i].a - a;
      const double db = places[i].b - b;
      const double below = depth - depths[i];
      isNear = isNear || (da * da + db * db <= LevelReach * LevelReach && below >= -LevelLeeway &&
                          below <= this->LayerThickness() + LevelLeeway);
    });
    return isNear;
  }

  /** Specks that noise left inside the lumen; polyps on thin stalks are larger. */
  void
  FillCavities()
  {
    const RunSet set =
      CollectRuns(m_Grid, [&](std::size_t p) { return m_Classes[p] != ColonGas && m_Classes[p] != ColonFluid; });
    const RunLabels          labels = LabelRuns(set, true);
    std::vector<std::size_t> voxels(labels.number + 1, 0);
    for (std::size_t r = 0; r < set.runs.size(); ++r)
    {
      voxels[labels.ofRun[r]] += set.runs[r].end - set.runs[r].begin;
    }
    const double half = 0.5 * (m_Evidence.thresholds.gas + m_Evidence.thresholds.fluid);
    ForEachRun(set, [&](std::size_t r, int j, int k) {
      if (voxels[labels.ofRun[r]] * m_Grid.VoxelVolume() * 1e-3 <= FilledCavityMl)
      {
        for (int i = set.runs[r].begin; i < set.runs[r].end; ++i)
        {
          const auto p = m_Grid.Index(i, j, k);
          const bool isGas = m_Evidence.thresholds.fluid <= 0.0 || m_Hu[p] < half;
          m_Classes[p] = isGas ? ColonGas : ColonFluid;
        }
      }
    });
  }

  const ColonImage * m_Image;
  ColonEvidence &    m_Evidence;
  VoxelBox           m_Box;
  ColonGrid          m_Grid;
  std::vector<float> m_Hu;
  ClassVolume        m_Classes;
  Fall               m_Fall;
  LevelColumn        m_Column;
  int                m_Layers;
};
} // namespace

LumenVoxels
DecideVoxels(const ColonImage * image, ColonEvidence & evidence)
{
  return VoxelDecision(image, evidence).Decide();
}
} // namespace itk
