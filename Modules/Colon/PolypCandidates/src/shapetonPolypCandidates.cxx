#include "shapetonPolypCandidates.h"

#include "shapetonCandidateList.h"
#include "shapetonColonDistension.h"
#include "shapetonColonSegments.h"
#include "shapetonPlaceInWords.h"
#include "shapetonScanResolution.h"
#include "shapetonSurfaceQuality.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Whether a candidate is at a valve, see RankValveLast(). */
bool
IsAt(const IleocecalValve & valve, const PolypCandidate & candidate)
{
  constexpr double leastReach = 12.0, beyondTheValve = 3.0; // mm
  return (candidate.position - valve.position).norm() <= std::max(leastReach, 0.5 * valve.length + beyondTheValve);
}
} // namespace

std::string
NameOf(PolypPreset preset)
{
  return preset == PolypPreset::Published ? "published" : "default";
}

double
StatedSize(double diameter)
{
  constexpr double tenths = 10.0; // per mm
  return std::round(tenths * diameter) / tenths;
}

PolypSize
SizeOf(double diameter)
{
  constexpr double from6 = 6.0, from10 = 10.0, from30 = 30.0; // mm; C-RADS
  const double     size = StatedSize(diameter);
  return size < from6    ? PolypSize::Below6
         : size < from10 ? PolypSize::From6To9
         : size < from30 ? PolypSize::From10
                         : PolypSize::From30;
}

std::string
SizeInWords(double diameter)
{
  return std::isfinite(diameter) ? InTenths(diameter) + " mm" : "";
}

std::string
NameOf(PolypSize size)
{
  switch (size)
  {
    case PolypSize::Below6:
      return "< 6 mm";
    case PolypSize::From6To9:
      return "6-9 mm";
    case PolypSize::From10:
      return ">= 10 mm";
    default:
      return ">= 30 mm";
  }
}

PolypTissue
TissueOf(double hounsfield)
{
  constexpr double leastOfFat = -150.0, leastOfSoft = -30.0, greatestOfSoft = 150.0; // HU; chosen, see PolypTissue
  return !std::isfinite(hounsfield)     ? PolypTissue::Unknown
         : hounsfield < leastOfFat      ? PolypTissue::Gas
         : hounsfield < leastOfSoft     ? PolypTissue::Fat
         : hounsfield <= greatestOfSoft ? PolypTissue::Soft
                                        : PolypTissue::Tagged;
}

std::string
NameOf(PolypTissue tissue)
{
  switch (tissue)
  {
    case PolypTissue::Gas:
      return "gas";
    case PolypTissue::Fat:
      return "fat";
    case PolypTissue::Soft:
      return "soft tissue";
    case PolypTissue::Tagged:
      return "tagged";
    case PolypTissue::WithGas:
      return "with gas inside";
    default:
      return "unknown";
  }
}

std::string
NameOf(PolypMorphology morphology)
{
  switch (morphology)
  {
    case PolypMorphology::Sessile:
      return "sessile";
    case PolypMorphology::Pedunculated:
      return "pedunculated";
    case PolypMorphology::Flat:
      return "flat";
    default:
      return "";
  }
}

std::string
NameOf(PolypLookalike lookalike)
{
  switch (lookalike)
  {
    case PolypLookalike::Valve:
      return "ileocecal valve";
    case PolypLookalike::AnalCanal:
      return "anal canal";
    case PolypLookalike::Catheter:
      return "rectal catheter";
    case PolypLookalike::Balloon:
      return "balloon of the rectal catheter";
    case PolypLookalike::Gas:
      return "gas";
    case PolypLookalike::Residue:
      return "residue of electronic cleansing";
    case PolypLookalike::Tagged:
      return "tagged stool or residue";
    default:
      return "";
  }
}

double
MatchedSmoothingTime(const SurfaceMesh & wall, double time)
{
  constexpr double usualVoxel = 0.8 * 0.8, facesOfVoxel = 3.0; // mm^2
  constexpr double timeForArea = 0.5, least = 0.3;             // mm^2 per mm^2, mm^2; see the header
  const double     voxel = facesOfVoxel * SurfaceArea(wall.V, wall.F) / std::max(1, wall.NumberOfFaces());
  return std::max(std::min(time, least), time - timeForArea * (voxel - usualVoxel));
}

std::vector<PolypCandidate>
FindPolypCandidates(const SurfaceMesh & wall, const PolypCandidateOptions & options)
{
  CheckOptions(options);
  const SurfaceConnectivity connectivity(wall);
  options.progress(0.2);
  const std::vector<char> isLeftOut = FindNoWall(wall, connectivity);
  options.progress(0.3);

  const double       time = MatchedSmoothingTime(wall, options.smoothingTime);
  const SurfaceShape shape =
    MeasureSurfaceShape(wall.V, connectivity, wall.F, time, options.progress.Part("", 0.3, 0.8));
  std::vector<PolypCandidate> candidates;
  const auto                  addParts = [&](std::vector<WallBulge> parts, double leastDiameter) {
    for (WallBulge & part : parts)
    {
      options.progress(0.9);
      const PolypFeatures features = FeaturesOf(part);
      const double        score = PolypScore(features);
      if (score < 1.0 - options.sensitivity)
      {
        continue;
      }
      PolypCandidate candidate = CandidateOf(std::move(part), features, score, wall);
      if (candidate.diameter >= leastDiameter)
      {
        candidates.push_back(std::move(candidate));
      }
    }
  };
  // Smaller plaques on phantoms are ripples of the wall.
  constexpr double leastDiameterOfPlaque = 8.0; // mm
  addParts(FindWallBulges(wall, connectivity, shape, isLeftOut, options.leastCurvature), options.leastDiameter);
  addParts(FindWallPlaques(wall, connectivity, shape, isLeftOut),
           std::max(options.leastDiameter, leastDiameterOfPlaque));
  SortAndNumber(candidates);
  return candidates;
}

void
NoteIleocecalValve(const std::vector<IleocecalValve> & alternatives, std::vector<PolypCandidate> & candidates)
{
  constexpr double least = 0.05; // chosen
  for (PolypCandidate & one : candidates)
  {
    double probability = 0.0;
    for (const IleocecalValve & alternative : alternatives)
    {
      probability = IsAt(alternative, one) ? std::max(probability, alternative.confidence) : probability;
    }
    if (one.lookalike != PolypLookalike::Valve && probability >= least)
    {
      AddRemark(std::string(MayBeTheValve) + " (" + std::to_string(std::lround(100.0 * probability)) + " %)", one);
    }
  }
}

void
RankValveLast(const IleocecalValve & valve, std::vector<PolypCandidate> & candidates)
{
  // Koenderink's limit between ridge and dome; the value of a cap is 1.
  constexpr double leastShapeIndexOfDomes = 13.0 / 16.0;
  for (PolypCandidate & one : candidates)
  {
    if (IsAt(valve, one))
    {
      one.lookalike = PolypLookalike::Valve;
      one.arcLength = valve.arcLength; // both lips are one structure, at the border of the cecum
      one.segment = one.segment > 0 ? NumberOfColonSegments : 0;
      one.score = std::min(one.score, 1.0 - defaultPolypSensitivity);
      if (one.features.shapeIndex <= leastShapeIndexOfDomes)
      {
        one.score *= 1.0 - valve.confidence;
      }
      AddRemark("the ileocecal valve", one);
    }
  }
  // Puts the valve last among equal scores, since Rank() is stable.
  std::stable_partition(candidates.begin(), candidates.end(), [](const PolypCandidate & one) {
    return one.lookalike != PolypLookalike::Valve;
  });
  Rank(candidates);
}

void
NoteAnalCanal(const CurveSet & centerline, std::vector<PolypCandidate> & candidates)
{
  constexpr double reach = 60.0; // mm
  const char *     what = "the centerline";
  const double     end =
    EndOfAnalCanal(PointValues(centerline, "arcLength", what), PointValues(centerline, "radius", what));
  for (PolypCandidate & candidate : candidates)
  {
    if (candidate.lookalike == PolypLookalike::None && candidate.arcLength <= end)
    {
      candidate.lookalike = PolypLookalike::AnalCanal;
      AddRemark(NameOf(candidate.lookalike), candidate);
    }
    else if (candidate.arcLength <= reach)
    {
      AddRemark("may be a rectal catheter, its balloon or hemorrhoids", candidate);
    }
  }
}

void
NoteSmallerThan(double notAssessableBelow, std::vector<PolypCandidate> & candidates)
{
  for (PolypCandidate & candidate : candidates)
  {
    if (candidate.diameter < notAssessableBelow)
    {
      AddRemark(NotAssessableInWords(notAssessableBelow), candidate);
    }
  }
}

void
RankCatheterLast(const CurveSet & catheter, std::vector<PolypCandidate> & candidates)
{
  constexpr double      reach = 3.0; // mm
  const char * const    what = "the rectal catheter";
  const Eigen::VectorXd tube = PointValues(catheter, "radius", what);
  const Eigen::VectorXd balloon = FindSurfaceArray(catheter.pointArrays, "balloonRadius") != nullptr
                                    ? PointValues(catheter, "balloonRadius", what)
                                    : Eigen::VectorXd::Zero(tube.size());
  for (PolypCandidate & candidate : candidates)
  {
    const Eigen::VectorXd toAxis = (catheter.V.rowwise() - candidate.position.transpose()).rowwise().norm();
    const bool            isOnTube = (toAxis - tube).minCoeff() <= reach;
    const bool            isOnBalloon = (balloon.array() > 0.0 && (toAxis - balloon).array() <= reach).any();
    if (isOnTube || isOnBalloon)
    {
      candidate.score = 0.0;
      candidate.lookalike = isOnTube ? PolypLookalike::Catheter : PolypLookalike::Balloon;
      candidate.remark = isOnTube ? what : std::string("the balloon of ") + what;
    }
  }
  Rank(candidates);
}
} // namespace shapeton
