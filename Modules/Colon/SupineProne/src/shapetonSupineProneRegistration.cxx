#include "shapetonSupineProneRegistration.h"

#include "shapetonColonSense.h"
#include "shapetonCommonTaeniae.h"
#include "shapetonFinalMap.h"
#include "shapetonRegistrationConfidence.h"
#include "shapetonExceptions.h"
#include "shapetonWarpingTrials.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
/** Measures whether folds distinguish the map from a map rotated by a third of a turn. */
void
JudgeThirds(const WarpingChoice & choice, RegistrationConfidence & confidence)
{
  confidence.energies = choice.energies;
  confidence.energy = choice.energies[0];
  confidence.margin = std::min(choice.energies[1], choice.energies[2]) - choice.energies[0];
}

void
RequireUsable(const ColonPosition & position)
{
  if (!position.flat)
  {
    throw InputError(position.name + ": the flat map is missing");
  }
  if (position.folds.empty())
  {
    throw InputError(position.name + ": no haustral folds to register; find them with ColonFolds");
  }
  RequireParameter(position.isExcluded.empty() ||
                     position.isExcluded.size() == static_cast<std::size_t>(position.flat->Grid().Columns()),
                   position.name + ": the number of excluded columns must match the grid");
}

/** Refuses parameters of the other map. */
void
RequireParametersOf(const SupineProneOptions & options)
{
  const SupineProneOptions usual;
  const bool               isPublished = options.map == SupineProneMap::Published;
  RequireParameter(
    !isPublished || !(options.refine || options.segmentWise || options.matching != usual.matching),
    "the published map supports none of the parameter \"refine\", the parameter \"segmentWise\" and the parameter "
    "\"matching\": it is always segment-wise, never refined, and has its own energy");
  RequireParameter(
    isPublished || (options.distanceWeight == usual.distanceWeight && options.border == usual.border),
    "the parameter \"distanceWeight\" and the parameter \"border\" belong to the published map; set the parameter "
    "\"map\" to \"published\", or leave them out");
}

/** The node nearest to a position. */
std::pair<int, int>
NearestNode(const CylinderNodes & nodes, const CylinderPlace & place)
{
  const int row = static_cast<int>(std::lround((place.s - nodes.begin) / nodes.step));
  const int angle = static_cast<int>(std::lround((place.turn - std::floor(place.turn)) * nodes.Angles()));
  return { std::clamp(row, 0, nodes.Rows() - 1), angle % nodes.Angles() };
}
} // namespace

SupineProneRegistration
RegisterColonPositions(const ColonPosition & source, const ColonPosition & target, const SupineProneSettings & options)
{
  RequireUsable(source);
  RequireUsable(target);
  CheckOptions(options);
  const bool isPublished = options.map == SupineProneMap::Published;
  RequireParametersOf(options);
  options.progress("Describing folds", 0.0);
  ColonPair               pair(source, target);
  SupineProneRegistration result;
  result.sourceFlat = source.flat;
  result.targetFlat = target.flat;
  result.source = pair.sourceCylinder;
  result.target = pair.targetCylinder;
  result.confidence.senseMargin = RequireSameSense({ source, *pair.sourceCylinder, pair.sourceFolds },
                                                   { target, *pair.targetCylinder, pair.targetFolds },
                                                   options.progress.Part("Comparing the orientation", 0.02, 0.15));
  FindFrame(pair, options.segmentWise, result.warnings);
  for (std::size_t i = 1; i + 1 < pair.frame.from.size(); ++i)
  {
    result.flexures.emplace_back(pair.frame.from[i], pair.frame.to[i]);
  }
  WarpingChoice choice = WarpByTrials(pair, options.matching, options.progress.Part("Warping", 0.15, 0.7));
  JudgeThirds(choice, result.confidence);
  if (options.refine)
  {
    RefineByPictures(pair, choice.best, options.progress.Part("Refining", 0.7, 0.8));
  }
  result.frame =
    CylinderMap(NodesOf(pair, { pair.frame, { choice.best.warp.s, choice.frameRotation }, nullptr, pair.Around() }));
  result.warp = CylinderMap(NodesOf(pair, choice.best.Warp(pair)));
  const Progress progress = options.progress.Part("Mapping", 0.8, 1.0);
  progress(0.0);
  if (isPublished)
  {
    MapAsPublished(pair, options, result, progress);
  }
  else
  {
    ProjectMap(pair, choice.best, options.greatestDilatation, result, progress);
  }
  JudgeRegistration(pair, result);
  result.taeniae = FindCommonTaeniae(pair, result);
  progress(1.0);
  return result;
}

Eigen::Vector2d
MapUv(const SupineProneRegistration & registration, const Eigen::Vector2d & sourceUv)
{
  return registration.target->UvOfPlace(registration.map.Forward(registration.source->PlaceOfUv(sourceUv)));
}

Eigen::Vector2d
InverseMapUv(const SupineProneRegistration & registration, const Eigen::Vector2d & targetUv)
{
  const std::optional<CylinderPlace> place = registration.map.Inverse(registration.target->PlaceOfUv(targetUv));
  return place ? registration.source->UvOfPlace(*place)
               : Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN()).eval();
}

double
ConfidenceAt(const SupineProneRegistration & registration, const CylinderPlace & place)
{
  const auto [row, angle] = NearestNode(registration.map.Nodes(), place);
  return registration.confidence.ofNodes(row, angle);
}

bool
IsExcludedAt(const SupineProneRegistration & registration, const CylinderPlace & place)
{
  const auto [row, angle] = NearestNode(registration.map.Nodes(), place);
  return registration.isExcluded(row, angle) != 0;
}
} // namespace shapeton
