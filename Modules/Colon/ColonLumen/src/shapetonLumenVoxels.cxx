#include "shapetonLumenVoxels.h"

#include "shapetonAirFluidInterface.h"
#include "shapetonCatheterFilling.h"
#include "shapetonConnectingFluid.h"
#include "shapetonHollowIslands.h"
#include "shapetonInterruption.h"
#include "shapetonParallelFor.h"
#include "shapetonSquaredDistances.h"
#include "shapetonTaggedPools.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shapeton
{
namespace
{
constexpr double LevelReach = 6.0;  // mm around the flat part of a level
constexpr double LevelLeeway = 0.5; // mm; a level is flat to 0.4 mm
constexpr double NearEdge = 0.4;    // relative to the contrast of the fluid at the edge of the level

/** Width (mm) of the transition from gas to fluid, that is, from 31 % to 81 % of a blurred step. */
double
LayerThickness(const LumenField & field)
{
  constexpr double widthInBlurs = 1.38; // quantiles of the normal distribution: 0.88 + 0.50
  return widthInBlurs * field.Blur();
}

/** Tests whether voxels are near levels of the colon. */
class NearLevels
{
public:
  explicit NearLevels(const LumenField & field)
    : m_Field(field), m_Deepest(LayerThickness(field) + LevelLeeway), m_Cells(this->CollectPlaces(), LevelReach)
  {}

  bool
  Hold(std::size_t p) const
  {
    const GravitySteps & fall = m_Field.fall;
    const auto           x = m_Field.grid.Position(p);
    const double         a = x.dot(fall.across[0]);
    const double         b = x.dot(fall.across[1]);
    const double         depth = x.dot(fall.direction);
    bool                 isNear = false;
    m_Cells.ForEachNear(a, b, [&](int i) {
      const double da = m_Places[i].a - a;
      const double db = m_Places[i].b - b;
      const double below = depth - m_Depths[i];
      isNear = isNear || (da * da + db * db <= LevelReach * LevelReach && below >= -LevelLeeway && below <= m_Deepest);
    });
    return isNear;
  }

private:
  const std::vector<LateralCells::Place> &
  CollectPlaces()
  {
    const GravitySteps & fall = m_Field.fall;
    for (const auto & level : m_Field.ColonLevels())
    {
      for (const auto floor : level.voxels)
      {
        const auto p = m_Field.evidence.grid.Position(floor);
        m_Places.push_back({ static_cast<float>(p.dot(fall.across[0])), static_cast<float>(p.dot(fall.across[1])) });
        const Eigen::Vector2d d = Eigen::Vector2d(m_Places.back().a, m_Places.back().b) - level.center;
        m_Depths.push_back(static_cast<float>(level.depth + level.slope.dot(d)));
      }
    }
    return m_Places;
  }

  const LumenField &               m_Field;
  double                           m_Deepest; ///< mm below a level
  std::vector<LateralCells::Place> m_Places;
  std::vector<float>               m_Depths;
  LateralCells                     m_Cells;
};

/** Searches up and down from a voxel with precomputed steps. */
class Column
{
public:
  Column(const LumenField & field, const ClassVolume & classes, int steps)
    : m_Grid(field.grid), m_Classes(classes), m_Steps(steps)
  {
    for (int t = -steps; t <= steps; ++t)
    {
      m_Offsets.push_back(field.fall.Offset(t));
    }
  }

  /** Whether the nearest classified voxels above and below, within the steps, are gas and fluid, respectively. */
  bool
  IsBetweenGasAndFluid(std::size_t p) const
  {
    const auto v = m_Grid.Voxel(p);
    const int  up = this->StepsTo(ColonGas, v, -1, m_Steps);
    return up > 0 && this->StepsTo(ColonFluid, v, 1, m_Steps + 1 - up) > 0;
  }

private:
  /** Steps to the first nonempty voxel if it is of this class; otherwise 0. */
  int
  StepsTo(unsigned char wanted, const std::array<int, 3> & v, int direction, int most) const
  {
    for (int step = 1; step <= most; ++step)
    {
      const auto & o = m_Offsets[m_Steps + direction * step];
      if (!m_Grid.Holds(v[0] + o[0], v[1] + o[1], v[2] + o[2]))
      {
        return 0;
      }
      const unsigned char found = m_Classes[m_Grid.Index(v[0] + o[0], v[1] + o[1], v[2] + o[2])];
      if (found != Nothing)
      {
        return found == wanted ? step : 0;
      }
    }
    return 0;
  }

  const ColonGrid &               m_Grid;
  const ClassVolume &             m_Classes;
  int                             m_Steps;
  std::vector<std::array<int, 3>> m_Offsets;
};

/** Fills the transition from gas to fluid, but only near levels; elsewhere, there may be a wall in between. */
void
FillLevelLayers(LumenField & field)
{
  const NearLevels  levels(field);
  const double      thickness = LayerThickness(field) + 2.0 * LevelLeeway;
  const int         steps = static_cast<int>(std::ceil(thickness / field.fall.step)) + 1;
  const double      half = 0.5 * (field.evidence.thresholds.gas + field.evidence.thresholds.fluid);
  const ClassVolume before = field.classes;
  const Column      column(field, before, steps);
  ParallelFor(field.grid.size[2], [&](std::size_t k) {
    for (std::size_t p = k * field.grid.stride[2]; p < (k + 1) * field.grid.stride[2]; ++p)
    {
      if (before[p] == Nothing && column.IsBetweenGasAndFluid(p) && levels.Hold(p))
      {
        field.classes[p] = field.hu[p] < half ? ColonGas : ColonFluid;
      }
    }
  });
}

constexpr double GrowthReach = 3.0;       // mm; chosen: the blurred edge
constexpr double LeastCompetingMl = 0.05; // minimum volume of competing bright matter
constexpr double FaintDepth = 2.0;        // mm below a level; search depth for faintly tagged fluid
constexpr double FilledCavityMl = 0.03;   // chosen: a ball of 3.9 mm; smaller than a polyp to be reported

void
PaintGas(LumenField & field)
{
  const ColonEvidence & e = field.evidence;
  ForEachRun(e.gas.set, [&](std::size_t r, int j, int k) {
    field.Fill(e.gas.set.runs[r], j, k, e.isColon[e.gas.labels.ofRun[r]] ? ColonGas : OtherGas);
  });
}

void
PaintBright(LumenField & field)
{
  const ColonEvidence &    e = field.evidence;
  std::vector<std::size_t> voxels(e.brightLabels.number + 1, 0);
  for (std::size_t r = 0; r < e.brightSet.runs.size(); ++r)
  {
    voxels[e.brightLabels.ofRun[r]] += e.brightSet.runs[r].end - e.brightSet.runs[r].begin;
  }
  ForEachRun(e.brightSet, [&](std::size_t r, int j, int k) {
    const int  piece = e.brightLabels.ofRun[r];
    const bool competes = voxels[piece] * field.grid.VoxelVolume() * 1e-3 >= LeastCompetingMl;
    field.Fill(e.brightSet.runs[r], j, k, e.isColonBright[piece] ? Undecided : competes ? OtherBright : Nothing);
  });
}

/** Adds gas pockets with a level on the fluid of the colon; returns whether there are any. */
bool
TakeGasOverFluid(LumenField & field)
{
  ColonEvidence & e = field.evidence;
  bool            found = false;
  for (const auto & level : e.levels)
  {
    if (!e.isColon[level.gas] && field.IsTagged(level) && field.LiesOnColonFluid(level))
    {
      e.isColon[level.gas] = 1;
      found = true;
    }
  }
  if (found)
  {
    ForEachRun(e.gas.set, [&](std::size_t r, int j, int k) {
      if (e.isColon[e.gas.labels.ofRun[r]])
      {
        field.Fill(e.gas.set.runs[r], j, k, ColonGas);
      }
    });
  }
  return found;
}

/** Marks bright pieces under levels of newly identified colon gas as undecided; returns whether there are any. */
bool
TakeBrightUnderGas(LumenField & field)
{
  ColonEvidence &   e = field.evidence;
  std::vector<char> isNew(e.isColonBright.size(), 0);
  bool              found = false;
  for (std::size_t l = 0; l < e.levels.size(); ++l)
  {
    for (const int piece : e.brightOfLevel[l])
    {
      if (e.isColon[e.levels[l].gas] && !e.isColonBright[piece])
      {
        e.isColonBright[piece] = 1;
        isNew[piece] = 1;
        found = true;
      }
    }
  }
  ForEachRun(e.brightSet, [&](std::size_t r, int j, int k) {
    if (isNew[e.brightLabels.ofRun[r]])
    {
      field.Fill(e.brightSet.runs[r], j, k, Undecided);
    }
  });
  return found;
}

/** Mask of the voxels near connecting fluid, or empty if there is none. */
std::vector<char>
NearConnectingFluid(const LumenField & field, const VoxelSet & connecting)
{
  std::vector<char> near;
  if (!connecting.empty())
  {
    std::vector<unsigned char> others(field.grid.NumberOfVoxels(), 1);
    for (const auto p : connecting)
    {
      others[p] = 0;
    }
    const auto &      spacing = field.grid.spacing;
    const VoxelValues squares =
      SquaredDistances(field.grid, { spacing[0], spacing[1], spacing[2] }, others, GrowthReach);
    near.resize(squares.size());
    std::transform(
      squares.begin(), squares.end(), near.begin(), [](float d) { return d <= GrowthReach * GrowthReach; });
  }
  return near;
}

/** Grows certain gas and fluid into adjacent voxels. Connecting fluid is uneven, so near it the half height is based on
 * the usual fluid where the local fluid is denser. */
void
Grow(LumenField & field, const VoxelSet & connecting)
{
  const ColonThresholds &    t = field.evidence.thresholds;
  const ClassVolume &        classes = field.classes;
  std::vector<unsigned char> mask(classes.size());
  std::transform(classes.begin(), classes.end(), mask.begin(), [](unsigned char c) { return c == ColonFluid; });
  const LocalFluid        fluid(field.grid, field.hu, mask, t.fluid);
  const std::vector<char> near = NearConnectingFluid(field, connecting);
  const int layers = std::max(2, static_cast<int>(std::lround(GrowthReach / std::cbrt(field.grid.VoxelVolume()))));
  GrowClasses(field.grid, field.classes, layers, [&](std::size_t p, unsigned char c) {
    if (c == ColonGas || c == OtherGas)
    {
      return field.hu[p] < t.gasBoundary;
    }
    const auto   v = field.grid.Voxel(p);
    const double local = fluid.At(v[0], v[1], v[2]);
    const double usual = !near.empty() && near[p] ? std::min(local, t.fluid) : local;
    return t.fluid > 0.0 && field.hu[p] > 0.5 * (t.tissue + usual);
  });
}

/** Voxels of faintly tagged fluid under the levels of the colon. */
std::vector<std::size_t>
FaintSeeds(const LumenField & field)
{
  std::vector<std::size_t> seeds;
  const double             tissue = field.evidence.thresholds.tissue;
  const int                steps = static_cast<int>(std::lround(0.5 + FaintDepth / field.fall.step));
  for (const auto & level : field.evidence.levels)
  {
    std::array<int, 3> v;
    for (const auto floor : level.voxels)
    {
      if (!field.evidence.isColon[level.gas] || !field.IsTagged(level) || !field.Local(floor, v))
      {
        continue;
      }
      const auto q = field.Below(v, steps);
      if (q >= 0 && field.classes[q] == Nothing &&
          std::abs(field.hu[q] - level.edge) < NearEdge * (level.edge - tissue))
      {
        seeds.push_back(q);
      }
    }
  }
  return seeds;
}

/** Adds unmixed fluid; detects walls in the unfiltered input, since the prefilter would blur them. */
void
AddUnmixed(const ColonImage * image, LumenField & field)
{
  const ColonEvidence & e = field.evidence;
  const auto            seeds = FaintSeeds(field);
  const auto            add = [&](const VoxelValues & sharp) {
    AddUnmixedFluid(field.grid, field.hu, sharp, e.thresholds, e.remainingNoise, e.smoothing, seeds, field.classes);
  };
  if (e.smoothing > 0.0)
  {
    add(LoadVoxels(image, field.grid));
  }
  else
  {
    add(field.hu);
  }
}

/** Removes noise specks inside the lumen, which are smaller than polyps on thin stalks. */
void
FillCavities(LumenField & field)
{
  ClassVolume &   classes = field.classes;
  const VoxelRuns set =
    CollectRuns(field.grid, [&](std::size_t p) { return classes[p] != ColonGas && classes[p] != ColonFluid; });
  const RunLabels          labels = LabelRuns(set);
  std::vector<std::size_t> voxels(labels.number + 1, 0);
  for (std::size_t r = 0; r < set.runs.size(); ++r)
  {
    voxels[labels.ofRun[r]] += set.runs[r].end - set.runs[r].begin;
  }
  const ColonThresholds & t = field.evidence.thresholds;
  const double            half = 0.5 * (t.gas + t.fluid);
  ForEachRun(set, [&](std::size_t r, int j, int k) {
    if (voxels[labels.ofRun[r]] * field.grid.VoxelVolume() * 1e-3 <= FilledCavityMl)
    {
      for (int i = set.runs[r].begin; i < set.runs[r].end; ++i)
      {
        const auto p = field.grid.Index(i, j, k);
        classes[p] = t.fluid <= 0.0 || field.hu[p] < half ? ColonGas : ColonFluid;
      }
    }
  });
}
} // namespace

LumenVoxels
DecideVoxels(const ColonImage * image, ColonEvidence & evidence)
{
  LumenField field(evidence);
  PaintGas(field);
  PaintBright(field);
  SplitAtNecks(field);
  while (TakeGasOverFluid(field) && TakeBrightUnderGas(field))
  {
    SplitAtNecks(field);
  }
  const VoxelSet connecting = TakeConnectingFluid(field);
  if (!connecting.empty())
  {
    TakeGasOverFluid(field);
  }
  Grow(field, connecting);
  AddUnmixed(image, field);
  FillLevelLayers(field);
  FillCavities(field);
  auto catheter = FillRectalCatheter(field);
  if (catheter && catheter->isSure)
  {
    FillCavities(field);
  }
  else
  {
    FillHollowIslands(field.grid, field.hu, evidence.thresholds.gasBoundary, field.classes);
  }
  auto levels = field.ColonLevels();
  return { field.grid, std::move(field.hu), std::move(field.classes), std::move(levels), std::move(catheter) };
}
} // namespace shapeton
