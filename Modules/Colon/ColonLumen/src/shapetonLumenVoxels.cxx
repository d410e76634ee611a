#include "shapetonLumenVoxels.h"

#include "shapetonCatheter.h"
#include "shapetonFluidNecks.h"
#include "shapetonLevelLayers.h"
#include "shapetonLocalFluid.h"
#include "shapetonLumenField.h"
#include "shapetonUnmixedFluid.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double GrowthReach = 3.0;    // mm
constexpr double LeastBrightMl = 0.05; // of other bright matter that competes
constexpr double FaintDepth = 2.0;     // mm below a level, where faintly tagged fluid is looked for
constexpr double FilledCavityMl = 0.03;

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
    const bool competes = voxels[piece] * field.grid.VoxelVolume() * 1e-3 >= LeastBrightMl;
    field.Fill(e.brightSet.runs[r], j, k, e.isColonBright[piece] ? Undecided : competes ? OtherBright : Nothing);
  });
}

/** Pockets of gas that share a level with the colon's fluid. */
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

/** Bright pieces under levels of gas that has become colon: to be decided like those found at first. */
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

/** Where gas and fluid are sure, they take what belongs to them around. */
void
Grow(LumenField & field)
{
  const ColonThresholds &    t = field.evidence.thresholds;
  const ClassVolume &        classes = field.classes;
  std::vector<unsigned char> mask(classes.size());
  std::transform(classes.begin(), classes.end(), mask.begin(), [](unsigned char c) { return c == ColonFluid; });
  const LocalFluid fluid(field.grid, field.hu, mask, t.fluid);
  const int layers = std::max(2, static_cast<int>(std::lround(GrowthReach / std::cbrt(field.grid.VoxelVolume()))));
  GrowClasses(field.grid, field.classes, layers, [&](std::size_t p, unsigned char c) {
    if (c == ColonGas || c == OtherGas)
    {
      return field.hu[p] < t.gasBoundary;
    }
    const auto v = field.grid.Voxel(p);
    return t.fluid > 0.0 && field.hu[p] > 0.5 * (t.tissue + fluid.At(v[0], v[1], v[2]));
  });
}

/** Faintly tagged fluid under the colon's levels, where no surely bright matter lies. */
std::vector<std::size_t>
FaintSeeds(const LumenField & field)
{
  std::vector<std::size_t> seeds;
  const double             tissue = field.evidence.thresholds.tissue;
  const int                steps = static_cast<int>(std::lround(0.5 + FaintDepth / field.fall.step));
  for (const auto & level : field.evidence.levels)
  {
    std::array<int, 3> v;
    for (const auto floor : level.floors)
    {
      if (!field.evidence.isColon[level.gas] || !field.IsTagged(level) || !field.Local(floor, v))
      {
        continue;
      }
      const auto q = field.Below(v, steps);
      if (q >= 0 && field.classes[q] == Nothing && std::abs(field.hu[q] - level.edge) < 0.4 * (level.edge - tissue))
      {
        seeds.push_back(q);
      }
    }
  }
  return seeds;
}

/** Walls are looked for in the input itself: the prefilter would hide them. */
void
AddUnmixed(const ColonImage * image, LumenField & field)
{
  const ColonEvidence & e = field.evidence;
  const auto            seeds = FaintSeeds(field);
  const auto            add = [&](const std::vector<float> & sharp) {
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

/** Specks that noise left inside the lumen; polyps on thin stalks are larger. */
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
  Grow(field);
  AddUnmixed(image, field);
  FillLevelLayers(field);
  FillCavities(field);
  FillCatheter(field.grid, field.hu, evidence.thresholds.gasBoundary, field.classes);
  auto levels = field.ColonLevels();
  return { field.grid, std::move(field.hu), std::move(field.classes), std::move(levels) };
}
} // namespace shapeton
