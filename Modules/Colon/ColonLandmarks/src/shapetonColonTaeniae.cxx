#include "shapetonColonTaeniae.h"

#include "shapetonFlatColonLocator.h"
#include "shapetonTaeniaEvidence.h"
#include "shapetonTaeniaMarkers.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
constexpr int    leastEnds = 24;             // of folds on the whole wall; chosen: fewer do not determine three tracks
constexpr double disagreement = 10.0;        // mm, as in the validation
constexpr double greatestDisagreement = 0.1; // share of the colon; chosen for the warning
constexpr double smoothing = 4.0;            // rows
constexpr double evidenceReach = 60.0;       // mm along the colon; chosen: two to three folds on each side
constexpr double evidenceWidth = 10.0;       // mm around it, as in the validation
constexpr double endsForCertainty = 4.0;     // within that reach; chosen
constexpr double leastContradiction = 3.0;   // mm; chosen for the warning

/** The second and third tracks follow the first in the row direction. */
TaeniaTracks
InOrderOfRows(TaeniaTracks tracks)
{
  double sum = 0.0;
  for (const TaeniaAngles & row : tracks)
  {
    sum += TurnsBetween(row[1], row[0] + 1.0 / 3.0) * TurnsBetween(row[1], row[0] + 1.0 / 3.0) -
           TurnsBetween(row[2], row[0] + 1.0 / 3.0) * TurnsBetween(row[2], row[0] + 1.0 / 3.0);
  }
  for (TaeniaAngles & row : tracks)
  {
    if (sum > 0.0)
    {
      std::swap(row[1], row[2]);
    }
  }
  return tracks;
}

/** Mean distance (mm) between corresponding tracks in each row, for the best of the three cyclic shifts. */
std::vector<double>
DistancesOf(const TaeniaEvidence & evidence, const TaeniaTracks & a, const TaeniaTracks & b)
{
  std::vector<double> best;
  double              least = std::numeric_limits<double>::max();
  for (int shift = 0; shift < 3; ++shift)
  {
    std::vector<double> distances;
    double              sum = 0.0;
    for (int row = 0; row < evidence.rows; ++row)
    {
      double turns = 0.0;
      for (int t = 0; t < 3; ++t)
      {
        turns += std::abs(TurnsBetween(a[row][t], b[row][(t + shift) % 3])) / 3.0;
      }
      distances.push_back(turns * evidence.girth[row]);
      sum += distances.back();
    }
    if (sum < least)
    {
      least = sum;
      best = distances;
    }
  }
  return best;
}

/** Runs both methods; returns the tracks to keep, and the disagreement in `distances`. */
TaeniaTracks
ChooseTracks(const TaeniaEvidence & evidence,
             const Progress &       progress,
             ColonTaeniae &         result,
             std::vector<double> &  distances)
{
  const bool         isPublished = result.rule == TaeniaRule::Published;
  const TaeniaTracks joint = SmoothedTracks(JointTaeniae(evidence, progress), smoothing);
  TaeniaTracks       fuzzy = FuzzyTaeniae(evidence, isPublished);
  result.jointEnergy = EnergyOfTaeniae(evidence, joint);
  if (fuzzy.empty())
  {
    result.warnings.push_back("no window of the wall contains enough fold ends for fuzzy C-means");
    result.fuzzyEnergy = std::numeric_limits<double>::quiet_NaN();
    distances.assign(evidence.rows, 0.0);
    result.kept = "joint";
    return isPublished ? TaeniaTracks{} : joint;
  }
  fuzzy = InOrderOfRows(fuzzy);
  result.fuzzyEnergy = EnergyOfTaeniae(evidence, fuzzy);
  distances = DistancesOf(evidence, joint, fuzzy);
  const bool takesFuzzy = isPublished || result.fuzzyEnergy < result.jointEnergy;
  result.kept = isPublished ? "thirds" : (takesFuzzy ? "fuzzyCMeans" : "joint");
  return takesFuzzy ? fuzzy : joint;
}

void
ReportDisagreement(const std::vector<double> & distances, ColonTaeniae & result)
{
  double sum = 0.0;
  for (const double distance : distances)
  {
    sum += distance;
  }
  const auto far = std::count_if(distances.begin(), distances.end(), [](double d) { return d > disagreement; });
  result.meanDisagreement = sum / static_cast<double>(distances.size());
  result.disagreeingShare = static_cast<double>(far) / static_cast<double>(distances.size());
  if (result.disagreeingShare > greatestDisagreement && result.markers.empty())
  {
    result.warnings.push_back("the two methods for taeniae disagree by more than 10 mm along " +
                              std::to_string(static_cast<int>(std::lround(100.0 * result.disagreeingShare))) +
                              " % of the colon: check them, or set markers");
  }
}

/** Warns about each marker that its taenia misses because the taenia passes through another marker. */
void
WarnOfMarkersThatDisagree(ColonTaeniae & result)
{
  for (std::size_t m = 0; m < result.markers.size(); ++m)
  {
    if (result.markers[m].distanceOfTaenia > leastContradiction)
    {
      result.warnings.push_back("marker " + std::to_string(m + 1) + " is " +
                                std::to_string(static_cast<int>(std::lround(result.markers[m].distanceOfTaenia))) +
                                " mm from another marker of taenia " + std::to_string(result.markers[m].taenia) +
                                ", which passes through the other marker: remove one of them");
    }
  }
}

/** Rotates the tracks to start with the lowest cost. */
TaeniaTracks
BestFirst(const TaeniaEvidence & evidence, const TaeniaTracks & tracks, std::vector<TaeniaPass> & passes)
{
  std::array<double, 3> cost{};
  for (int row = 0; row < evidence.rows; ++row)
  {
    for (int t = 0; t < 3; ++t)
    {
      cost[t] += evidence.CostAt(row, TaeniaEvidence::CellOf(tracks[row][t]));
    }
  }
  const int    first = static_cast<int>(std::min_element(cost.begin(), cost.end()) - cost.begin());
  TaeniaTracks result;
  for (const TaeniaAngles & row : tracks)
  {
    result.push_back({ row[first], row[(first + 1) % 3], row[(first + 2) % 3] });
  }
  for (TaeniaPass & pass : passes)
  {
    pass.track = (pass.track - first + 3) % 3;
  }
  return result;
}

double
ConfidenceAt(const TaeniaEvidence & evidence, int row, double angle, double distance)
{
  double count = 0.0;
  for (const FoldEnd & end : evidence.ends)
  {
    const int other = static_cast<int>(end.row);
    if (std::abs(evidence.arcLength[other] - evidence.arcLength[row]) < evidenceReach)
    {
      count += std::abs(TurnsBetween(end.angle, angle)) * evidence.girth[other] < evidenceWidth ? 1.0 : 0.0;
    }
  }
  const double agreement = std::exp(-distance * distance / (2.0 * disagreement * disagreement));
  return agreement * std::min(1.0, count / endsForCertainty);
}

ColonTaenia
TaeniaOnWall(const FlatColonGrid &       grid,
             const TaeniaEvidence &      evidence,
             const TaeniaTracks &        tracks,
             const std::vector<double> & distances,
             int                         track)
{
  ColonTaenia taenia;
  for (int row = 0; row < evidence.rows; ++row)
  {
    const double     turns = evidence.turns.ToMap(row, tracks[row][track]);
    const double     angle = turns - std::floor(turns);
    const int        column = std::min(static_cast<int>((row + 0.5) * evidence.columnsPerRow), grid.Columns() - 1);
    const int        pixelRow = std::min(static_cast<int>(angle * grid.Rows()), grid.Rows() - 1);
    const FlatSample sample = grid.SampleOfPixel(column, pixelRow);
    if (sample.face >= 0)
    {
      Eigen::Vector2d uv = grid.UvOfPixel(column, pixelRow);
      uv[1] -= grid.Circumference() * std::floor(uv[1] / grid.Circumference());
      taenia.points.push_back(sample.point);
      taenia.uv.push_back(uv);
      taenia.arcLength.push_back(evidence.arcLength[row]);
      taenia.confidence.push_back(ConfidenceAt(evidence, row, tracks[row][track], distances[row]));
    }
  }
  return taenia;
}

SurfaceArray
PointArray(const std::string & name, int rows, int components)
{
  return { name, SurfaceArray::ValueMatrix(rows, components), false };
}
} // namespace

std::string
NameOf(TaeniaRule rule)
{
  return rule == TaeniaRule::Joint ? "joint" : "published";
}

ColonTaeniae
FindColonTaeniae(const FlatColon & flat, const ColonWallTube & tube, const ColonTaeniaOptions & options)
{
  const FlatColonGrid & grid = flat.Grid();
  HaustralFoldSettings  foldOptions;
  foldOptions.progress = options.progress.Part("", 0.0, 0.3);
  const HaustralFolds folds = FindHaustralFolds(flat, foldOptions);
  TaeniaEvidence      evidence = MakeTaeniaEvidence(flat, tube, folds, options.rule);
  options.progress(0.4);
  const FlatColonLocator locator(grid);
  ColonTaeniae           result;
  result.rule = options.rule;
  std::vector<TaeniaPass> passes = LocateMarkers(options.markers, grid, locator, evidence, result.markers);
  if (static_cast<int>(evidence.ends.size()) < leastEnds && passes.size() < 3)
  {
    result.reason = "only " + std::to_string(folds.folds.size()) +
                    " folds were found, too few to locate taeniae; set at least three markers";
    result.warnings.push_back("no taenia was found: " + result.reason);
    return result;
  }
  std::vector<double> distances;
  TaeniaTracks        tracks = ChooseTracks(evidence, options.progress.Part("", 0.4, 0.9), result, distances);
  if (tracks.empty())
  {
    result.reason = "too few fold ends for the fuzzy C-means of the published rule";
    result.warnings.push_back("no taenia was found: " + result.reason);
    return result;
  }
  options.progress(0.9);
  ReportDisagreement(distances, result);
  PassThroughMarkers(evidence, passes, tracks);
  tracks = BestFirst(evidence, tracks, passes);
  for (int t = 0; t < 3; ++t)
  {
    result.taeniae.push_back(TaeniaOnWall(grid, evidence, tracks, distances, t));
  }
  InsertMarkers(passes, result);
  WarnOfMarkersThatDisagree(result);
  return result;
}

CurveSet
TaeniaCurves(const ColonTaeniae & taeniae)
{
  CurveSet curves;
  int      size = 0;
  for (const ColonTaenia & taenia : taeniae.taeniae)
  {
    size += static_cast<int>(taenia.points.size());
  }
  curves.V.resize(size, 3);
  SurfaceArray arcLength = PointArray("arcLength", size, 1);
  SurfaceArray uv = PointArray("uv", size, 2);
  SurfaceArray confidence = PointArray("confidence", size, 1);
  SurfaceArray number = PointArray("taenia", static_cast<int>(taeniae.taeniae.size()), 1);
  number.areIntegers = true;
  int next = 0;
  for (std::size_t t = 0; t < taeniae.taeniae.size(); ++t)
  {
    const ColonTaenia & taenia = taeniae.taeniae[t];
    number.values(t, 0) = static_cast<double>(t + 1);
    curves.curves.emplace_back();
    for (std::size_t i = 0; i < taenia.points.size(); ++i)
    {
      curves.V.row(next) = taenia.points[i].transpose();
      arcLength.values(next, 0) = taenia.arcLength[i];
      uv.values.row(next) = taenia.uv[i].transpose();
      confidence.values(next, 0) = taenia.confidence[i];
      curves.curves.back().push_back(next++);
    }
  }
  curves.pointArrays = { arcLength, uv, confidence };
  curves.cellArrays = { number };
  return curves;
}
} // namespace shapeton
