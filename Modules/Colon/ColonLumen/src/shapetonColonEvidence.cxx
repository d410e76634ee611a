#include "shapetonColonEvidence.h"

#include "shapetonAirFluidLevels.h"
#include "shapetonColonGravity.h"
#include "shapetonColonVolume.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <sstream>
#include <unordered_set>

namespace shapeton
{
namespace
{
constexpr double SeedShare = 0.7;          // fraction of the range from tissue to fluid
constexpr double BrighterBowel = 1.2;      // contrast of another bowel relative to the fluid of the colon
constexpr double FaintestPercentile = 0.1; // share of the area of tagged levels; chosen: ignores few faint levels
constexpr double FaintestShare = 0.75;     // relative to the contrast of typical fluid
constexpr double ReachUnderLevel = 8.0;    // mm

/** Area-weighted percentile of the levels. */
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

/** Large levels on bright fluid, whether or not the gas above is colon. */
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

/** Bright pieces just below a level that cover at least PoolArea of it and are mostly not separated from it by a wall.
 * One level may cover several pools. */
std::vector<int>
BrightUnder(const ColonEvidence & evidence, const GravitySteps & fall, const Level & level)
{
  const LevelColumn column(
    evidence.grid, evidence.hu, fall, evidence.thresholds, evidence.remainingNoise, evidence.smoothing);
  std::map<int, LevelColumn::Votes> votes;
  for (const auto floor : level.voxels)
  {
    const auto v = evidence.grid.Voxel(floor);
    for (int t = 1; t * fall.step <= std::max(ReachUnderLevel, StepsToFluid * fall.step); ++t)
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

/** Upper bound on the intensity of a wall between the fluid and a brighter bowel, including noise and the blur of the
 * prefilter. */
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
AddTiltedLevels(ColonEvidence & evidence)
{
  const GravitySteps fall(evidence.grid, evidence.gravity);
  if (!evidence.isTagged || fall.step > ThinnestWall)
  {
    return;
  }
  const auto &                    t = evidence.thresholds;
  std::unordered_set<std::size_t> known;
  for (const auto & level : evidence.levels)
  {
    known.insert(level.voxels.begin(), level.voxels.end());
  }
  auto floors =
    FloorsOfGas(evidence.grid, evidence.hu, evidence.gas.set, evidence.gas.labels, evidence.isColon, fall, t);
  floors.erase(
    std::remove_if(floors.begin(), floors.end(), [&](const Floor & floor) { return known.count(floor.voxel) > 0; }),
    floors.end());
  for (const auto & level : FindLevels(evidence.grid, evidence.hu, floors, fall, t.tissue, TiltedLevels))
  {
    if (level.IsTagged(t.tissue) && level.edge - t.tissue > FaintestShare * (t.fluid - t.tissue))
    {
      evidence.levels.push_back(level);
    }
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
  const GravitySteps fall(evidence.grid, evidence.gravity);
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
  constexpr double margin = 12.0;    // mm; chosen
  constexpr double analCanal = 50.0; // mm; chosen: the length of a long anal canal
  box = evidence.grid.Widened(box, margin);
  // Extended to include the anal canal, since it may contain a catheter.
  const int canal = static_cast<int>(analCanal / evidence.grid.spacing[2]);
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

namespace
{
constexpr double SeedReach = 2.0;       // mm; chosen: a click next to the lumen
constexpr double LeastContrast = 150.0; // HU; contrast of bright matter to tissue

std::string
NameOf(const itk::Point<double, 3> & point)
{
  std::ostringstream name;
  name << "the seed point " << point[0] << ',' << point[1] << ',' << point[2];
  return name.str();
}

std::size_t
VoxelOf(const ColonGrid & grid, const itk::Point<double, 3> & point)
{
  const Eigen::Vector3d    x = grid.VoxelOf(Eigen::Vector3d(point[0], point[1], point[2]));
  const std::array<int, 3> v{
    { static_cast<int>(std::lround(x[0])), static_cast<int>(std::lround(x[1])), static_cast<int>(std::lround(x[2])) }
  };
  RequireParameter(x.allFinite() && grid.Holds(v[0], v[1], v[2]), NameOf(point) + " is outside the image");
  return grid.Index(v[0], v[1], v[2]);
}

/** The nearby voxel where `sign` * value is greatest, if above a threshold. */
std::optional<std::size_t>
MostExtreme(const ColonEvidence & evidence, std::size_t voxel, double sign, double threshold)
{
  std::optional<std::size_t> best;
  double                     most = sign * threshold;
  ForAllWithin(evidence.grid, voxel, SeedReach, [&](std::size_t p, double) {
    if (sign * evidence.hu[p] > most)
    {
      most = sign * evidence.hu[p];
      best = p;
    }
    return true;
  });
  return best;
}
} // namespace

LumenSeeds
FindSeedVoxels(const ColonEvidence & evidence, const std::vector<itk::Point<double, 3>> & points)
{
  LumenSeeds seeds;
  for (const auto & point : points)
  {
    const std::size_t voxel = VoxelOf(evidence.grid, point);
    if (const auto gas = MostExtreme(evidence, voxel, -1.0, evidence.thresholds.gasSeed))
    {
      seeds.gas.push_back(evidence.grid.Voxel(*gas));
      continue;
    }
    const auto bright = MostExtreme(evidence, voxel, 1.0, evidence.thresholds.tissue + LeastContrast);
    RequireParameter(bright.has_value(),
                     NameOf(point) +
                       " is in neither gas nor bright fluid; give a point inside the lumen of the colon, in LPS, mm");
    seeds.bright.push_back(evidence.grid.Voxel(*bright));
  }
  return seeds;
}

namespace
{
constexpr double ClearLevels = 500.0; // mm^2
constexpr double ClearRatio = 3.0;    // relative to the levels of the given direction; chosen
// Required to override a file header. In a well-tagged examination, levels cover 200 cm^2; in other directions, at most
// 3 cm^2.
constexpr double CertainLevels = 5000.0; // mm^2
constexpr double CertainRatio = 5.0;

/** Flat levels along one direction. */
struct LevelsOfDirection
{
  itk::Vector<double, 3> gravity;
  std::vector<Level>     levels;
  double                 area{ 0.0 }; ///< mm^2
};

LevelsOfDirection
LevelsAlong(const ColonEvidence & e, const itk::Vector<double, 3> & gravity)
{
  const GravitySteps fall(e.grid, Eigen::Vector3d(gravity[0], gravity[1], gravity[2]));
  const auto         floors = FloorsOfGas(e.grid, e.hu, e.gas.set, e.gas.labels, e.isCandidate, fall, e.thresholds);
  LevelsOfDirection  found;
  found.gravity = gravity;
  found.levels = FindLevels(e.grid, e.hu, floors, fall, e.thresholds.tissue);
  found.area = std::accumulate(
    found.levels.begin(), found.levels.end(), 0.0, [](double sum, const Level & level) { return sum + level.area; });
  return found;
}

bool
Outweigh(const LevelsOfDirection & levels, double least, double ratio, double others)
{
  return levels.area >= least && levels.area > ratio * others;
}

void
WarnOfGravity(const std::string & patientPosition, const LevelsOfDirection * contradiction, ColonLumen & lumen)
{
  if (contradiction)
  {
    const std::string position = NameOfGravity(contradiction->gravity);
    const std::string used = lumen.gravitySource == ColonGravitySource::PatientPosition
                               ? "the given position was used; if it is wrong, tagged fluid is missed"
                               : position + " was used, since headers are often wrong";
    lumen.warnings.push_back(
      "the patient position \"" + patientPosition +
      "\" contradicts the fluid levels in the data: " + std::to_string(std::lround(contradiction->area)) +
      " mm^2 of flat levels indicate " + position + "; " + used + "; check the slices and give the correct position");
  }
  if (lumen.gravitySource == ColonGravitySource::Assumed)
  {
    lumen.warnings.push_back("no patient position is given and no clear fluid levels were found; supine is assumed");
  }
}
} // namespace

void
FindGravity(const std::string & position, ColonEvidence & evidence, ColonLumen & lumen)
{
  const auto given = GivenGravity(position);
  const auto assumed = *GravityOfPatientPosition("supine");
  // Levels for the given or assumed direction, and for the direction with the largest area of levels.
  LevelsOfDirection usual;
  LevelsOfDirection clearest;
  for (const char * name : { "supine", "prone", "leftDecubitus", "rightDecubitus" })
  {
    const auto        gravity = *GravityOfPatientPosition(name);
    LevelsOfDirection found = LevelsAlong(evidence, gravity);
    if (gravity == (given ? *given : assumed))
    {
      usual = found;
    }
    if (found.area > clearest.area)
    {
      clearest = std::move(found);
    }
  }
  const bool isClear = Outweigh(clearest, ClearLevels, ClearRatio, given ? usual.area : 0.0);
  const bool isContradiction = given && isClear && !(clearest.gravity == *given);
  // A named position is always used; only a DICOM code can be overridden.
  const bool isOfHeader = given && position != NameOfGravity(*given);
  const bool isOverruled = isContradiction && isOfHeader && Outweigh(clearest, CertainLevels, CertainRatio, usual.area);
  lumen.gravitySource = given && !isOverruled ? ColonGravitySource::PatientPosition
                        : isClear             ? ColonGravitySource::Levels
                                              : ColonGravitySource::Assumed;
  WarnOfGravity(position, isContradiction ? &clearest : nullptr, lumen);
  const LevelsOfDirection & taken = lumen.gravitySource == ColonGravitySource::Levels ? clearest : usual;
  lumen.gravity = taken.gravity;
  evidence.levels = taken.levels;
  evidence.gravity = Eigen::Vector3d(taken.gravity[0], taken.gravity[1], taken.gravity[2]);
}
} // namespace shapeton
