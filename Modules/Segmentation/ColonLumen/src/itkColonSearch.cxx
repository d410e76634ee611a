#include "itkColonSearch.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace itk
{
namespace
{
constexpr double CoreRadius = 10.0; // mm; gas in small bowel stays thinner
constexpr double CoreMl = 20.0;     //
constexpr double WideRadius = 12.5; // mm; beyond the calibre of small bowel, 25 mm
constexpr double WideMl = 8.0;      //
constexpr double CutRadius = 7.0;   // mm; how much a piece holds that the image's border cuts is not known
constexpr double CutMl = 2.0;       //
constexpr double LungShare = 0.1;   // of the way from gas to tissue
constexpr double PoolArea = 20.0;   // mm^2
constexpr double SeedShare = 0.7;   // of the way from tissue to fluid
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

/** The bright pieces that columns under a level meet within 8 mm, on 20 mm^2 at least; one level may cover several
 * pools. */
std::vector<int>
BrightUnder(const ColonEvidence & evidence, const Fall & fall, const Level & level)
{
  std::map<int, int> votes;
  for (const auto floor : level.floors)
  {
    const auto v = evidence.grid.Voxel(floor);
    for (int t = 1; t * fall.step <= 8.0; ++t)
    {
      const auto o = fall.Offset(t);
      if (!evidence.grid.Holds(v[0] + o[0], v[1] + o[1], v[2] + o[2]))
      {
        break;
      }
      const auto run = evidence.brightSet.Find(v[0] + o[0], v[1] + o[1], v[2] + o[2]);
      if (run >= 0)
      {
        ++votes[evidence.brightLabels.ofRun[run]];
        break;
      }
    }
  }
  std::vector<int> pieces;
  for (const auto & vote : votes)
  {
    if (vote.second * fall.ColumnArea(evidence.grid) >= PoolArea)
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
} // namespace

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
  return isWide ? "" : "small bowel or undistended colon";
}

void
ChooseCore(ColonEvidence & evidence)
{
  const auto & pieces = evidence.gas.pieces;
  evidence.isCandidate.assign(pieces.size(), 0);
  evidence.isColon.assign(pieces.size(), 0);
  for (std::size_t p = 1; p < pieces.size(); ++p)
  {
    const auto kind = KindOfGas(pieces[p], evidence.thresholds);
    evidence.isCandidate[p] = kind != "outside air" && kind != "lung" && pieces[p].ml >= 0.05;
    evidence.isColon[p] = kind.empty();
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
  evidence.isTagged = !tagged.empty();
  auto & t = evidence.thresholds;
  if (evidence.isTagged)
  {
    t.fluid = PercentileBelow(tagged, 0.5);
    const double faintest =
      std::max(PercentileBelow(tagged, FaintestPercentile), t.tissue + FaintestShare * (t.fluid - t.tissue));
    t.fluidSeed = t.tissue + SeedShare * (faintest - t.tissue);
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
  return box.IsEmpty() ? box : evidence.grid.Widened(box, 12.0);
}
} // namespace itk
