#include "itkColonSearch.h"

#include "itkColonStatistics.h"
#include "itkLevelColumn.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace itk
{
namespace
{
constexpr double CoreRadius = 10.0;    // mm; gas in small bowel stays thinner
constexpr double CoreMl = 20.0;        //
constexpr double WideRadius = 12.5;    // mm; beyond the calibre of small bowel, 25 mm
constexpr double WideMl = 8.0;         //
constexpr double CutRadius = 7.0;      // mm; how much a piece holds that the image's border cuts is not known
constexpr double CutMl = 2.0;          //
constexpr double LungShare = 0.1;      // of the way from gas to tissue
constexpr double LargeLevel = 200.0;   // mm^2
constexpr double FaintShare = 0.5;     // of the typical fluid's contrast
constexpr double StomachShare = 0.25;  // of the colon's gas
constexpr double LongestColumn = 60.0; // mm
constexpr double PoolArea = 20.0;      // mm^2
constexpr double SeedShare = 0.7;      // of the way from tissue to fluid
constexpr double BrighterBowel = 1.2;  // bowel's contrast by that of the colon's fluid
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

const char * const SmallBowel = "small bowel or undistended colon";

/** Why a piece of gas is no colon; empty for one that may be. */
std::string
KindOfGas(const GasPiece & piece, const ColonThresholds & thresholds)
{
  if (piece.isOutside)
  {
    return "outside air";
  }
  if (piece.radius > 0.0 && piece.inside > thresholds.gas + LungShare * (thresholds.tissue - thresholds.gas))
  {
    return "lung";
  }
  const bool isWide = (piece.radius >= CoreRadius && piece.ml >= CoreMl) ||
                      (piece.radius >= WideRadius && piece.ml >= WideMl) ||
                      (piece.isCut && piece.radius >= CutRadius && piece.ml >= CutMl);
  return isWide ? "" : SmallBowel;
}

/** Area of a piece's levels: over fluid as bright as the colon's, and over anything fainter. */
struct LevelAreas
{
  double bright{ 0.0 };
  double faint{ 0.0 };
};

std::vector<LevelAreas>
AreasOfPieces(const ColonEvidence & evidence)
{
  const auto &            t = evidence.thresholds;
  std::vector<LevelAreas> areas(evidence.gas.pieces.size());
  for (const auto & level : evidence.levels)
  {
    const bool isBright = level.IsTagged(t.tissue) && level.Fluid() - t.tissue > FaintShare * (t.fluid - t.tissue);
    (isBright ? areas[level.gas].bright : areas[level.gas].faint) += level.area;
  }
  return areas;
}

/** Voxel steps to the places around a column, up to 4 mm across gravity: the rim of a level is not flat. */
std::vector<std::array<int, 3>>
StepsAround(const ColonGrid & grid, const Fall & fall)
{
  std::vector<std::array<int, 3>> steps(1, { { 0, 0, 0 } });
  for (int n = 0; n < 16; ++n)
  {
    const double          angle = 0.78539816 * (n % 8);
    const double          reach = n < 8 ? 2.0 : 4.0;
    const Eigen::Vector3d x = reach * (std::cos(angle) * fall.across[0] + std::sin(angle) * fall.across[1]);
    const Eigen::Vector3d v = grid.VoxelOf(grid.origin + x);
    steps.push_back({ { static_cast<int>(std::lround(v[0])),
                        static_cast<int>(std::lround(v[1])),
                        static_cast<int>(std::lround(v[2])) } });
  }
  return steps;
}

/** Adds what is brighter than `least` in the column under a voxel; the first 3.5 mm may be the blurred layer. */
void
AddColumn(const ColonEvidence &             evidence,
          const Fall &                      fall,
          const std::array<int, 3> &        v,
          double                            least,
          std::vector<std::array<int, 3>> & voxels)
{
  for (int n = 1; n * fall.step < LongestColumn; ++n)
  {
    const auto               o = fall.Offset(n);
    const std::array<int, 3> w{ { v[0] + o[0], v[1] + o[1], v[2] + o[2] } };
    if (!evidence.grid.Holds(w[0], w[1], w[2]))
    {
      return;
    }
    if (n * fall.step > 3.5 && evidence.hu[evidence.grid.Index(w[0], w[1], w[2])] < least)
    {
      return;
    }
    voxels.push_back(w);
  }
}

/** The fluid in columns under the levels of one piece and around them. */
std::vector<std::array<int, 3>>
ColumnsUnder(const ColonEvidence & evidence, int piece)
{
  const auto &                    t = evidence.thresholds;
  const Fall                      fall(evidence.grid, evidence.gravity);
  const auto                      around = StepsAround(evidence.grid, fall);
  std::vector<std::array<int, 3>> voxels;
  for (const auto & level : evidence.levels)
  {
    if (level.gas != piece || !level.IsTagged(t.tissue))
    {
      continue;
    }
    for (const auto floor : level.floors)
    {
      const auto v = evidence.grid.Voxel(floor);
      for (const auto & s : around)
      {
        AddColumn(
          evidence, fall, { { v[0] + s[0], v[1] + s[1], v[2] + s[2] } }, 0.5 * (t.tissue + level.Fluid()), voxels);
      }
    }
  }
  return voxels;
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
ChooseCore(ColonEvidence & evidence)
{
  const auto & pieces = evidence.gas.pieces;
  evidence.isCandidate.assign(pieces.size(), 0);
  evidence.isColon.assign(pieces.size(), 0);
  evidence.kind.assign(pieces.size(), "outside air");
  for (std::size_t p = 1; p < pieces.size(); ++p)
  {
    evidence.kind[p] = KindOfGas(pieces[p], evidence.thresholds);
    evidence.isCandidate[p] = evidence.kind[p] != "outside air" && evidence.kind[p] != "lung" && pieces[p].ml >= 0.05;
    evidence.isColon[p] = evidence.kind[p].empty();
  }
}

void
ReviewCore(ColonEvidence & evidence)
{
  const auto areas = AreasOfPieces(evidence);
  double     colonMl = 0.0;
  for (std::size_t p = 1; p < areas.size(); ++p)
  {
    colonMl += evidence.isColon[p] ? evidence.gas.pieces[p].ml : 0.0;
  }
  for (std::size_t p = 1; p < areas.size(); ++p)
  {
    const auto & piece = evidence.gas.pieces[p];
    if (evidence.isTagged && evidence.isCandidate[p] && areas[p].faint > std::max(LargeLevel, 3.0 * areas[p].bright) &&
        piece.ml < StomachShare * colonMl)
    {
      evidence.kind[p] = "stomach";
      evidence.isColon[p] = 0;
    }
    else if (!evidence.isColon[p] && evidence.isCandidate[p] && areas[p].bright >= PoolArea && piece.ml >= 1.0)
    {
      const auto both =
        MeasureTogether(evidence.grid, evidence.gas, static_cast<int>(p), ColumnsUnder(evidence, static_cast<int>(p)));
      evidence.isColon[p] = both.radius >= WideRadius && both.ml >= CoreMl;
      evidence.kind[p] = evidence.isColon[p] ? "" : evidence.kind[p];
    }
  }
}

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
  evidence.brightLabels = LabelRuns(evidence.brightSet, true);
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
} // namespace itk
