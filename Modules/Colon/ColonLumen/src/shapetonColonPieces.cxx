#include "shapetonColonPieces.h"

#include "shapetonAirFluidLevels.h"
#include "shapetonColonExtent.h"
#include "shapetonPi.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
/** Limits chosen on two validation exams, hard 105 and 108 (supine). The rule has no effect in 38 other exams with
 * seeds 100 to 109. */
constexpr double RectumLead = 30.0;     // mm; required difference in distance to the anus
constexpr double FarthestRectum = 60.0; // mm; loops of small bowel in the pelvis are higher or more anterior

/** Calls `body(piece, point)` for both ends of each run. */
template <typename TBody>
void
ForEachEnd(const ColonGrid & grid, const VoxelRuns & set, const RunLabels & labels, const TBody & body)
{
  ForEachRun(set, [&](std::size_t r, int j, int k) {
    for (const int i : { set.runs[r].begin, set.runs[r].end - 1 })
    {
      body(labels.ofRun[r], grid.Position(Eigen::Vector3d(i, j, k)));
    }
  });
}

ColonExtent
ExtentOfBowel(const ColonEvidence & evidence)
{
  ColonExtent extent;
  ForEachEnd(evidence.grid, evidence.gas.set, evidence.gas.labels, [&](int piece, const Eigen::Vector3d & point) {
    if (evidence.isCandidate[piece])
    {
      extent.Include(point);
    }
  });
  return extent;
}

/** For each piece, the distance from the anus to its nearest voxel. */
std::vector<double>
DistancesFromAnus(const ColonGrid & grid, const VoxelRuns & set, const RunLabels & labels, const ColonExtent & extent)
{
  std::vector<double> distances(labels.number + 1, std::numeric_limits<double>::infinity());
  ForEachEnd(grid, set, labels, [&](int piece, const Eigen::Vector3d & point) {
    distances[piece] = std::min(distances[piece], extent.DistanceFromAnus(point));
  });
  return distances;
}

/** Minimum over the selected pieces; infinity if none is selected. */
double
NearestOf(const std::vector<double> & distances, const std::vector<char> & isChosen)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t p = 1; p < isChosen.size(); ++p)
  {
    nearest = isChosen[p] ? std::min(nearest, distances[p]) : nearest;
  }
  return nearest;
}
} // namespace

std::vector<char>
PiecesNearerToAnus(const ColonEvidence & evidence, const VoxelRuns & set, const RunLabels & labels)
{
  const ColonExtent extent = ExtentOfBowel(evidence);
  const auto        ofGas = DistancesFromAnus(evidence.grid, evidence.gas.set, evidence.gas.labels, extent);
  const auto        ofBright = DistancesFromAnus(evidence.grid, evidence.brightSet, evidence.brightLabels, extent);
  const double      colon = std::min(NearestOf(ofGas, evidence.isColon), NearestOf(ofBright, evidence.isColonBright));
  std::vector<char> areNearer;
  for (const double distance : DistancesFromAnus(evidence.grid, set, labels, extent))
  {
    areNearer.push_back(std::isfinite(colon) && distance <= std::min(FarthestRectum, colon - RectumLead));
  }
  areNearer[0] = 0;
  return areNearer;
}

namespace
{
constexpr double CoreRadius = 10.0;    // mm; gas in small bowel is thinner
constexpr double CoreMl = 20.0;        // chosen with CoreRadius on one real colon
constexpr double WideRadius = 12.5;    // mm; small bowel has a caliber of at most 25 mm
constexpr double WideMl = 8.0;         // chosen: excludes short pieces
constexpr double CutRadius = 7.0;      // mm; for pieces of unknown size, cut by the image border
constexpr double CutMl = 2.0;          // chosen: excludes short pieces
constexpr double RectumRadius = 7.0;   // mm; of gas and fluid near the anus
constexpr double LungShare = 0.1;      // of the way from gas to tissue; chosen
constexpr double CandidateMl = 0.05;   // smaller gas is noise
constexpr double LungMl = 500.0;       // minimum volume of lungs for identifying airways by height
constexpr double LungHeight = 150.0;   // mm of lungs in the image; a flexure may be next to their lower half
constexpr double FaintShare = 0.5;     // relative to the contrast of typical fluid
constexpr double StomachShare = 0.25;  // relative to the gas of the colon
constexpr double LongestColumn = 60.0; // mm; chosen: limits the depth of a pool

const char * const Stomach = "stomach";

/** Kind of a piece of gas outside the colon; empty if it may be colon. */
std::string
KindOfGas(const GasPiece & piece, const LungEvidence & lung, const ColonThresholds & thresholds)
{
  if (piece.isOutside) // under a thin shell, as lung may be under a thin chest wall
  {
    return lung.IsVascularLung() ? LungKind : OutsideKind;
  }
  const double densest = thresholds.gas + LungShare * (thresholds.tissue - thresholds.gas);
  if ((piece.radius > 0.0 && piece.inside > densest) || lung.IsLung())
  {
    return LungKind;
  }
  const bool isWide = (piece.radius >= CoreRadius && piece.ml >= CoreMl) ||
                      (piece.radius >= WideRadius && piece.ml >= WideMl) ||
                      (piece.isCut && piece.radius >= CutRadius && piece.ml >= CutMl);
  return isWide ? "" : SmallBowelKind;
}

/** Areas of the levels of a piece on fluid as bright as in the colon, and on fainter matter. */
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

/** Voxel offsets around a column, up to 4 mm perpendicular to gravity, since the rim of a level is not flat. */
std::vector<std::array<int, 3>>
StepsAround(const ColonGrid & grid, const GravitySteps & fall)
{
  std::vector<std::array<int, 3>> steps(1, { { 0, 0, 0 } });
  for (int n = 0; n < 16; ++n)
  {
    const double          angle = 0.25 * Pi * (n % 8);
    const double          reach = n < 8 ? 2.0 : 4.0;
    const Eigen::Vector3d x = reach * (std::cos(angle) * fall.across[0] + std::sin(angle) * fall.across[1]);
    const Eigen::Vector3d v = grid.VoxelOf(grid.origin + x);
    steps.push_back({ { static_cast<int>(std::lround(v[0])),
                        static_cast<int>(std::lround(v[1])),
                        static_cast<int>(std::lround(v[2])) } });
  }
  return steps;
}

/** Adds voxels in the column under a voxel: all voxels of the first part, which may be a blurred layer, and then those
 * brighter than `least`. */
void
AddColumn(const ColonEvidence &             evidence,
          const GravitySteps &              fall,
          const std::array<int, 3> &        v,
          double                            least,
          std::vector<std::array<int, 3>> & voxels)
{
  constexpr double blurred = 3.5; // mm; chosen: the blurred layer of a level
  for (int n = 1; n * fall.step < LongestColumn; ++n)
  {
    const auto               o = fall.Offset(n);
    const std::array<int, 3> w{ { v[0] + o[0], v[1] + o[1], v[2] + o[2] } };
    if (!evidence.grid.Holds(w[0], w[1], w[2]))
    {
      return;
    }
    if (n * fall.step > blurred && evidence.hu[evidence.grid.Index(w[0], w[1], w[2])] < least)
    {
      return;
    }
    voxels.push_back(w);
  }
}

/** The fluid in the columns under and around the levels of one piece. */
std::vector<std::array<int, 3>>
ColumnsUnder(const ColonEvidence & evidence, int piece)
{
  const auto &                    t = evidence.thresholds;
  const GravitySteps              fall(evidence.grid, evidence.gravity);
  const auto                      around = StepsAround(evidence.grid, fall);
  std::vector<std::array<int, 3>> voxels;
  for (const auto & level : evidence.levels)
  {
    if (level.gas != piece || !level.IsTagged(t.tissue))
    {
      continue;
    }
    for (const auto floor : level.voxels)
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

void
MarkStomach(ColonEvidence & evidence, const std::vector<LevelAreas> & areas)
{
  double colonMl = 0.0;
  for (std::size_t p = 1; p < areas.size(); ++p)
  {
    colonMl += evidence.isColon[p] ? evidence.gas.pieces[p].ml : 0.0;
  }
  for (std::size_t p = 1; p < areas.size(); ++p)
  {
    if (evidence.isTagged && evidence.isCandidate[p] && areas[p].faint > std::max(LargeLevel, 3.0 * areas[p].bright) &&
        evidence.gas.pieces[p].ml < StomachShare * colonMl)
    {
      evidence.kind[p] = Stomach;
      evidence.isColon[p] = 0;
    }
  }
}

/** Adds to the colon those allowed pieces that, together with the fluid below them, contain a ball of this radius;
 * returns them. */
std::vector<int>
TakeOverFluid(ColonEvidence &                 evidence,
              const std::vector<LevelAreas> & areas,
              double                          radius,
              const std::vector<char> &       mayBeTaken)
{
  std::vector<int> taken;
  for (int p = 1; p < static_cast<int>(areas.size()); ++p)
  {
    if (!mayBeTaken[p] || evidence.isColon[p] || !evidence.isCandidate[p] || evidence.kind[p] == Stomach ||
        areas[p].bright < PoolArea || evidence.gas.pieces[p].ml < 1.0)
    {
      continue;
    }
    const auto both = MeasureTogether(evidence.grid, evidence.gas, p, ColumnsUnder(evidence, p));
    if (both.radius >= radius && both.ml >= CoreMl)
    {
      evidence.isColon[p] = 1;
      evidence.kind[p].clear();
      taken.push_back(p);
    }
  }
  return taken;
}

/** Caudal and cranial end of a piece, mm in LPS. */
std::array<double, 2>
HeightsOf(const ColonGrid & grid, const GasPiece & piece)
{
  const double low = grid.Position(Eigen::Vector3d(grid.size[0] / 2, grid.size[1] / 2, piece.box.low[2]))[2];
  const double high = grid.Position(Eigen::Vector3d(grid.size[0] / 2, grid.size[1] / 2, piece.box.high[2] - 1))[2];
  return { { std::min(low, high), std::max(low, high) } };
}

/** Marks gas that is only next to the cranial half of the lungs, as in the airways or the esophagus. */
void
MarkAirways(ColonEvidence & evidence)
{
  const auto &          pieces = evidence.gas.pieces;
  double                ml = 0.0;
  std::array<double, 2> lungs{ { std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest() } };
  for (std::size_t p = 1; p < pieces.size(); ++p)
  {
    if (evidence.kind[p] == LungKind && pieces[p].ml >= CoreMl)
    {
      const auto heights = HeightsOf(evidence.grid, pieces[p]);
      lungs = { { std::min(lungs[0], heights[0]), std::max(lungs[1], heights[1]) } };
      ml += pieces[p].ml;
    }
  }
  if (ml < LungMl || lungs[1] - lungs[0] < LungHeight)
  {
    return;
  }
  for (std::size_t p = 1; p < pieces.size(); ++p)
  {
    const bool isInside = evidence.kind[p] != LungKind && evidence.kind[p] != OutsideKind;
    if (isInside && HeightsOf(evidence.grid, pieces[p])[0] > 0.5 * (lungs[0] + lungs[1]))
    {
      evidence.kind[p] = AirwayKind;
    }
  }
}
} // namespace

void
ChooseCore(ColonEvidence & evidence)
{
  const auto &     pieces = evidence.gas.pieces;
  const LungSearch lungs(evidence.grid, evidence.hu, evidence.gas, evidence.thresholds.tissue, evidence.remainingNoise);
  evidence.isCandidate.assign(pieces.size(), 0);
  evidence.isColon.assign(pieces.size(), 0);
  evidence.kind.assign(pieces.size(), OutsideKind);
  evidence.lung.assign(pieces.size(), LungEvidence());
  for (int p = 1; p < static_cast<int>(pieces.size()); ++p)
  {
    if (pieces[p].ml >= CoreMl)
    {
      evidence.lung[p] = lungs.Measure(p);
    }
    evidence.kind[p] = KindOfGas(pieces[p], evidence.lung[p], evidence.thresholds);
  }
  MarkAirways(evidence);
  for (std::size_t p = 1; p < pieces.size(); ++p)
  {
    const std::string & kind = evidence.kind[p];
    evidence.isCandidate[p] =
      kind != OutsideKind && kind != LungKind && kind != AirwayKind && pieces[p].ml >= CandidateMl;
    evidence.isColon[p] = kind.empty();
  }
}

std::vector<int>
ReviewCore(ColonEvidence & evidence)
{
  const auto areas = AreasOfPieces(evidence);
  MarkStomach(evidence, areas);
  TakeOverFluid(evidence, areas, WideRadius, std::vector<char>(areas.size(), 1));
  return TakeOverFluid(
    evidence, areas, RectumRadius, PiecesNearerToAnus(evidence, evidence.gas.set, evidence.gas.labels));
}
} // namespace shapeton
