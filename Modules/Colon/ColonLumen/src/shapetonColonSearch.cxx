#include "shapetonColonSearch.h"

#include "shapetonColonStatistics.h"
#include "shapetonLevelColumn.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace shapeton
{
namespace
{
constexpr double SeedShare = 0.7;     // of the way from tissue to fluid
constexpr double BrighterBowel = 1.2; // bowel's contrast by that of the colon's fluid
constexpr double FaintestPercentile = 0.1;
constexpr double FaintestShare = 0.75; // of the typical fluid's contrast

/** The value that a share of the levels' area stays below. */
double
PercentileBelow(std::vector<const Level *> levels, double share)
{
  std::sort(levels.begin(), levels.end(), [](const Level * p, const Level * q) { return p->Fluid() < q->Fluid(); });
  const double total =
    std::accumulate(levels.begin(), levels.end(), 0.0, [](double sum, const Level * l) { return sum + l->area; });
  double sum = 0.0;
  for (const auto * level : levels)
  {
    sum += level->area;
    if (sum >= share * total)
    {
      return level->Fluid();
    }
  }
  return levels.back()->Fluid();
}

/** Large levels over bright fluid, whatever the gas above them. */
std::vector<const Level *>
LargeTaggedLevels(const ColonEvidence & evidence)
{
  std::vector<const Level *> tagged;
  for (const auto & level : evidence.levels)
  {
    if (level.area >= LargeLevel && level.IsTagged(evidence.thresholds.tissue))
    {
      tagged.push_back(&level);
    }
  }
  return tagged;
}

/** The bright pieces that columns under a level meet within 8 mm, on 20 mm^2 at least and mostly without a wall in
 * between; one level may cover several pools. */
std::vector<int>
BrightUnder(const ColonEvidence & evidence, const Fall & fall, const Level & level)
{
  const LevelColumn column(
    evidence.grid, evidence.hu, fall, evidence.thresholds, evidence.remainingNoise, evidence.smoothing);
  std::map<int, LevelColumn::Votes> votes;
  for (const auto floor : level.floors)
  {
    const auto v = evidence.grid.Voxel(floor);
    for (int t = 1; t * fall.step <= std::max(8.0, StepsToFluid * fall.step); ++t)
    {
      const auto o = fall.Offset(t);
      if (!evidence.grid.Holds(v[0] + o[0], v[1] + o[1], v[2] + o[2]))
      {
        break;
      }
      const auto run = evidence.brightSet.Find(v[0] + o[0], v[1] + o[1], v[2] + o[2]);
      if (run >= 0)
      {
        auto & vote = votes[evidence.brightLabels.ofRun[run]];
        vote.open += column.IsOpen(level, v, t);
        ++vote.all;
        break;
      }
    }
  }
  std::vector<int> pieces;
  for (const auto & vote : votes)
  {
    if (vote.second.open * fall.ColumnArea(evidence.grid) >= PoolArea && vote.second.AreOpen())
    {
      pieces.push_back(vote.first);
    }
  }
  return pieces;
}

void
Enclose(VoxelBox & box, const std::array<int, 3> & low, const std::array<int, 3> & high)
{
  const bool isNew = box.IsEmpty();
  for (int a = 0; a < 3; ++a)
  {
    box.low[a] = isNew ? low[a] : std::min(box.low[a], low[a]);
    box.high[a] = isNew ? high[a] : std::max(box.high[a], high[a]);
  }
}

/** What a wall between the fluid and a bowel that is brighter still may reach, noise included: the more the prefilter
 * blurs, the brighter walls are. */
double
BrightestWall(const ColonEvidence & evidence)
{
  const auto & t = evidence.thresholds;
  return t.tissue + BrighterBowel * ShareInWall(evidence.grid, evidence.smoothing) * (t.fluid - t.tissue) +
         2.0 * evidence.remainingNoise;
}
} // namespace

void
MeasureFluid(ColonEvidence & evidence)
{
  std::vector<const Level *> tagged;
  for (const auto & level : evidence.levels)
  {
    if (evidence.isColon[level.gas] && level.IsTagged(evidence.thresholds.tissue))
    {
      tagged.push_back(&level);
    }
  }
  if (tagged.empty())
  {
    tagged = LargeTaggedLevels(evidence);
  }
  evidence.isTagged = !tagged.empty();
  auto & t = evidence.thresholds;
  if (evidence.isTagged)
  {
    t.fluid = PercentileBelow(tagged, 0.5);
    const double faintest =
      std::max(PercentileBelow(tagged, FaintestPercentile), t.tissue + FaintestShare * (t.fluid - t.tissue));
    t.fluidSeed = std::max(t.tissue + SeedShare * (faintest - t.tissue), BrightestWall(evidence));
    t.fluidBoundary = 0.5 * (t.tissue + t.fluid);
  }
  else if (!evidence.brightSeeds.empty())
  {
    const auto & v = evidence.brightSeeds[0];
    t.fluid = evidence.hu[evidence.grid.Index(v[0], v[1], v[2])];
    t.fluidSeed = t.tissue + SeedShare * (t.fluid - t.tissue);
    t.fluidBoundary = 0.5 * (t.tissue + t.fluid);
  }
}

void
FindBright(ColonEvidence & evidence)
{
  const auto & t = evidence.thresholds;
  const double above = t.fluid > 0.0 ? t.fluidSeed : 1e9;
  evidence.brightSet = CollectRuns(evidence.grid, [&](std::size_t p) { return evidence.hu[p] > above; });
  evidence.brightLabels = LabelRuns(evidence.brightSet);
  evidence.isColonBright.assign(evidence.brightLabels.number + 1, 0);
  evidence.brightOfLevel.clear();
  const Fall fall(evidence.grid, evidence.gravity);
  for (const auto & level : evidence.levels)
  {
    const bool isTagged = level.IsTagged(t.tissue);
    evidence.brightOfLevel.push_back(isTagged ? BrightUnder(evidence, fall, level) : std::vector<int>());
    for (const int piece : evidence.brightOfLevel.back())
    {
      evidence.isColonBright[piece] = evidence.isColonBright[piece] || evidence.isColon[level.gas];
    }
  }
  for (const auto & v : evidence.brightSeeds)
  {
    const auto run = evidence.brightSet.Find(v[0], v[1], v[2]);
    evidence.isColonBright[run < 0 ? 0 : evidence.brightLabels.ofRun[run]] = 1;
  }
  evidence.isColonBright[0] = 0;
}

VoxelBox
BoxOfColon(const ColonEvidence & evidence)
{
  VoxelBox          box;
  std::vector<char> gas = evidence.isColon;
  for (std::size_t l = 0; l < evidence.levels.size(); ++l)
  {
    for (const int piece : evidence.brightOfLevel[l])
    {
      gas[evidence.levels[l].gas] = gas[evidence.levels[l].gas] || evidence.isColonBright[piece];
    }
  }
  for (std::size_t p = 1; p < gas.size(); ++p)
  {
    if (gas[p])
    {
      Enclose(box, evidence.gas.pieces[p].box.low, evidence.gas.pieces[p].box.high);
    }
  }
  ForEachRun(evidence.brightSet, [&](std::size_t r, int j, int k) {
    if (evidence.isColonBright[evidence.brightLabels.ofRun[r]])
    {
      Enclose(
        box, { { evidence.brightSet.runs[r].begin, j, k } }, { { evidence.brightSet.runs[r].end, j + 1, k + 1 } });
    }
  });
  if (box.IsEmpty())
  {
    return box;
  }
  box = evidence.grid.Widened(box, 12.0);
  // The anal canal, which may hold a catheter.
  const int canal = static_cast<int>(50.0 / evidence.grid.spacing[2]);
  if (evidence.grid.axes(2, 2) > 0.0)
  {
    box.low[2] = std::max(0, box.low[2] - canal);
  }
  else
  {
    box.high[2] = std::min(evidence.grid.size[2], box.high[2] + canal);
  }
  return box;
}
} // namespace shapeton
