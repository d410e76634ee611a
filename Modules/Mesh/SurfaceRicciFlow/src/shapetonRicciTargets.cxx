#include "shapetonRicciTargets.h"

#include "shapetonExceptions.h"
#include "shapetonNumberText.h"
#include "shapetonPi.h"

#include <set>

namespace shapeton
{
namespace
{
/** Accepted rounding error of a sum of curvatures (radians). */
constexpr double sumTolerance = 1e-6;

bool
IsEven(const SurfaceRicciFlowSettings & options, RicciGeometry geometry, const RicciTopology & topology)
{
  return options.boundary == RicciBoundary::Even ||
         (options.boundary == RicciBoundary::Auto && geometry == RicciGeometry::Euclidean && options.cones.empty() &&
          topology.characteristic != 0);
}

/** Distributes the same total over each boundary, by length. */
void
AddEvenBoundaries(const SurfaceConnectivity & connectivity,
                  const Eigen::VectorXd &     lengths,
                  double                      total,
                  Eigen::VectorXd &           targets)
{
  const auto & loops = connectivity.BoundaryLoops();
  for (const auto & loop : loops)
  {
    std::vector<double> sides;
    double              whole = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      sides.push_back(lengths[connectivity.FindEdge(loop[i], loop[(i + 1) % loop.size()])]);
      whole += sides.back();
    }
    const double perLength = total / static_cast<double>(loops.size()) / whole;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      targets[loop[i]] += 0.5 * perLength * (sides[i] + sides[(i + loop.size() - 1) % loop.size()]);
    }
  }
}

void
RequireCones(const SurfaceRicciFlowSettings & options, int vertices)
{
  std::set<int> distinct;
  for (const int v : options.cones)
  {
    RequireParameter(v >= 0 && v < vertices && distinct.insert(v).second,
                     "the parameter \"cones\": vertex " + std::to_string(v) +
                       " is repeated or does not exist; the surface has vertices 0 to " + std::to_string(vertices - 1));
  }
  RequireParameter(options.coneCurvatures.empty() || options.coneCurvatures.size() == options.cones.size(),
                   "the parameter \"coneCurvatures\" has " + std::to_string(options.coneCurvatures.size()) +
                     " values for " + std::to_string(options.cones.size()) + " cones");
}

/** Targets of cones and boundaries from the options. */
Eigen::VectorXd
TargetsOfOptions(const SurfaceRicciFlowSettings & options,
                 RicciGeometry                    geometry,
                 const RicciTopology &            topology,
                 const SurfaceConnectivity &      connectivity,
                 const Eigen::VectorXd &          lengths)
{
  RequireCones(options, connectivity.NumberOfVertices());
  Eigen::VectorXd targets = Eigen::VectorXd::Zero(connectivity.NumberOfVertices());
  const double    total = TwoPi * topology.characteristic;
  double          rest = total;
  const bool      isEven = topology.boundaries > 0 && IsEven(options, geometry, topology);
  const bool      areGiven = !options.coneCurvatures.empty();
  RequireParameter(options.cones.empty() || areGiven || (geometry == RicciGeometry::Euclidean && !isEven),
                   "the parameter \"coneCurvatures\" is required in hyperbolic geometry and with even boundaries");
  for (std::size_t i = 0; i < options.cones.size(); ++i)
  {
    targets[options.cones[i]] =
      areGiven ? options.coneCurvatures[i] : total / static_cast<double>(options.cones.size());
    rest -= targets[options.cones[i]];
  }
  if (isEven)
  {
    RequireParameter(geometry == RicciGeometry::Euclidean,
                     "the parameter \"boundary\" = even requires euclidean geometry");
    AddEvenBoundaries(connectivity, lengths, rest, targets);
  }
  return targets;
}

void
RequireSum(RicciGeometry geometry, int characteristic, Eigen::VectorXd & targets)
{
  const double required = TwoPi * characteristic;
  const double sum = targets.sum();
  const auto   words = [](double value) { return NumberText(value / Pi) + " pi"; };
  if (geometry == RicciGeometry::Hyperbolic)
  {
    RequireParameter(sum > required + sumTolerance,
                     "the sum of the curvatures is " + words(sum) + "; in hyperbolic geometry it must be more than " +
                       words(required) + " (2 pi times the Euler characteristic)");
    return;
  }
  RequireParameter(std::abs(sum - required) <= sumTolerance,
                   "the sum of the curvatures is " + words(sum) + ", but the surface requires " + words(required) +
                     " (2 pi times the Euler characteristic); choose cones that carry the difference");
  targets.array() += (required - sum) / static_cast<double>(targets.size());
}
} // namespace

RicciGeometry
ChooseGeometry(const SurfaceRicciFlowSettings & options, const RicciTopology & topology, const std::string & what)
{
  RicciGeometry geometry = options.geometry;
  if (geometry == RicciGeometry::Auto)
  {
    const bool areGiven = !options.cones.empty() || options.targetCurvatures.size() > 0;
    const bool isHyperbolic = topology.boundaries > 0 ? topology.genus > 0 : topology.genus > 1;
    const bool isSphere = topology.boundaries == 0 && topology.genus == 0;
    geometry = areGiven       ? RicciGeometry::Euclidean
               : isHyperbolic ? RicciGeometry::Hyperbolic
               : isSphere     ? RicciGeometry::Spherical
                              : RicciGeometry::Euclidean;
  }
  if (geometry == RicciGeometry::Spherical)
  {
    if (topology.boundaries > 0 || topology.genus > 0)
    {
      throw InputError(what + ": spherical geometry requires a closed surface of genus 0, but it has genus " +
                       std::to_string(topology.genus) + " and " + std::to_string(topology.boundaries) + " boundaries");
    }
    RequireParameter(options.cones.empty() && options.targetCurvatures.size() == 0,
                     "the parameter \"geometry\" = spherical has uniform curvature and allows no cones");
    RequireParameter(options.scheme == RicciScheme::VertexScaling,
                     "the parameter \"scheme\" = inversiveDistance is not available in spherical geometry");
  }
  return geometry;
}

Eigen::VectorXd
FindTargets(const SurfaceRicciFlowSettings & options,
            RicciGeometry                    geometry,
            const RicciTopology &            topology,
            const SurfaceConnectivity &      connectivity,
            const Eigen::VectorXd &          lengths)
{
  Eigen::VectorXd targets = options.targetCurvatures;
  if (targets.size() == 0)
  {
    targets = TargetsOfOptions(options, geometry, topology, connectivity, lengths);
  }
  else
  {
    RequireParameter(options.cones.empty() && options.boundary == RicciBoundary::Auto,
                     "curvatures of the vertices replace the parameters \"cones\" and \"boundary\"");
    RequireParameter(targets.size() == connectivity.NumberOfVertices(),
                     "there are " + std::to_string(targets.size()) + " target curvatures for " +
                       std::to_string(connectivity.NumberOfVertices()) + " vertices");
  }
  for (int v = 0; v < connectivity.NumberOfVertices(); ++v)
  {
    const bool isBoundary = connectivity.IsBoundaryVertex(v);
    RequireParameter(targets[v] < (isBoundary ? Pi : TwoPi),
                     "the curvature " + NumberText(targets[v]) + " of vertex " + std::to_string(v) + " must be below " +
                       (isBoundary ? "pi, because it is on a boundary" : "2 pi"));
  }
  if (geometry != RicciGeometry::Spherical)
  {
    RequireSum(geometry, topology.characteristic, targets);
  }
  return targets;
}
} // namespace shapeton
