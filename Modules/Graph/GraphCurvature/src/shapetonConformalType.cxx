#include "shapetonConformalType.h"

#include "shapetonBallMap.h"
#include "shapetonCirclePacking.h"
#include "shapetonExceptions.h"
#include "shapetonPackedMap.h"
#include "shapetonSparseCholesky.h"

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN(); // no result

/** Hyperbolic radius of the root circle if the apex circle is the ideal boundary. The dual map is packed, because the
 * horocycles, the circles of the nodes adjacent to the apex, are face circles there. */
double
RadiusOfRoot(const PackedMap & packed, int root, int apex)
{
  const CombinatorialMap dual = packed.map.Dual();
  const auto        faceOf = [&](int node) { return dual.Face(CombinatorialMap::Twin(packed.map.FirstAround(node))); };
  CirclesAtInfinity infinite;
  infinite.lineNodes.assign(dual.Nodes(), 0);
  infinite.lineFaces.assign(dual.Faces(), 0);
  infinite.horocycleFaces.assign(dual.Faces(), 0);
  infinite.lineFaces[faceOf(apex)] = 1; // meets only lines, and no kite is computed
  for (const int h : dual.Boundary(faceOf(apex)))
  {
    infinite.lineNodes[dual.Node(h)] = 1;
    infinite.horocycleFaces[dual.Face(CombinatorialMap::Twin(h))] = 1;
  }
  const CirclePacking packing = PackCircles(dual, FlowGeometry::Hyperbolic, infinite);
  return packing.faceRadii[faceOf(root)];
}

/** Effective resistance between the root and the nodes joined to the apex. */
double
ResistanceOf(const BallMap & ball)
{
  std::vector<int> unknown(ball.map.Nodes(), 0);
  unknown[ball.apex] = -1;
  for (const int h : ball.map.Around(ball.apex))
  {
    unknown[ball.map.Node(CombinatorialMap::Twin(h))] = -1;
  }
  int number = 0;
  for (int & node : unknown)
  {
    node = node < 0 ? -1 : number++;
  }
  std::vector<Eigen::Triplet<double>> elements;
  for (int h = 0; h < 2 * ball.diskEdges; ++h)
  {
    const int a = unknown[ball.map.Node(h)];
    const int b = unknown[ball.map.Node(CombinatorialMap::Twin(h))];
    if (a >= 0 && ball.map.Node(h) != ball.map.Node(CombinatorialMap::Twin(h)))
    {
      elements.emplace_back(a, a, 1.0);
      if (b >= 0)
      {
        elements.emplace_back(a, b, -1.0);
      }
    }
  }
  Eigen::SparseMatrix<double> laplacian(number, number);
  laplacian.setFromTriplets(elements.begin(), elements.end());
  Eigen::MatrixXd potential = Eigen::MatrixXd::Zero(number, 1);
  potential(unknown[ball.root], 0) = 1.0;
  return SolvePositiveDefinite(laplacian, potential) ? potential(unknown[ball.root], 0) : NotANumber;
}

PackedBall
Measured(const BallMap & ball)
{
  PackedBall measured;
  measured.radius = ball.radius;
  measured.nodes = ball.map.Nodes() - 1;
  std::vector<char> isBoundary(ball.map.Nodes(), 0);
  for (const int h : ball.map.Around(ball.apex))
  {
    isBoundary[ball.map.Node(CombinatorialMap::Twin(h))] = 1;
  }
  measured.boundaryNodes = static_cast<int>(std::count(isBoundary.begin(), isBoundary.end(), 1));
  const PackedMap packed = MakePackedMap(ball.map);
  measured.dummies = packed.map.Nodes() - ball.map.Nodes();
  measured.rootRadius = RadiusOfRoot(packed, ball.root, ball.apex);
  measured.modulus = -std::log(std::tanh(measured.rootRadius / 2.0));
  measured.resistance = ResistanceOf(ball);
  return measured;
}

/** 1, 2, ..., 8, and then each larger than the previous one by up to a quarter. */
std::vector<int>
RadiiUpTo(int most)
{
  constexpr int    consecutive = 8;
  constexpr int    parts = 4;
  std::vector<int> radii;
  for (int radius = 1; radius <= most; radius += radius < consecutive ? 1 : radius / parts)
  {
    radii.push_back(radius);
  }
  return radii;
}

/** Remaining growth extrapolated from the last two increments, assumed to be those of a - c ratio^n. */
double
GeometricRest(const std::vector<double> & radii, const std::vector<double> & quantities)
{
  constexpr int     halvings = 60;
  const std::size_t last = radii.size() - 1;
  const double      step = radii[last] - radii[last - 1];
  const double      stepBefore = radii[last - 1] - radii[last - 2];
  const double      increment = quantities[last] - quantities[last - 1];
  const double      growth = increment / (quantities[last - 1] - quantities[last - 2]);
  double            low = 0.0;
  double            high = 1.0;
  for (int i = 0; i < halvings; ++i)
  {
    const double ratio = (low + high) / 2.0;
    const double power = std::pow(ratio, stepBefore);
    (power * (1.0 - std::pow(ratio, step)) / (1.0 - power) < growth ? low : high) = ratio;
  }
  const double power = std::pow(low, step);
  return increment * power / (1.0 - power);
}

void
Conclude(ConformalTypeResult & result)
{
  std::vector<double> radii;
  std::vector<double> moduli;
  std::vector<double> resistances;
  for (const PackedBall & ball : result.balls)
  {
    radii.push_back(ball.radius);
    moduli.push_back(ball.modulus);
    resistances.push_back(ball.resistance);
  }
  result.packing = JudgeGrowth(radii, moduli);
  result.resistance = JudgeGrowth(radii, resistances);
  result.type = result.packing.type == result.resistance.type ? result.packing.type : ConformalType::NotDecided;
  const auto radiusOf = [&](double modulus) {
    return result.type == ConformalType::NotDecided ? NotANumber : 2.0 * std::atanh(std::exp(-modulus));
  };
  result.limitRadius = radiusOf(result.packing.limit);
  result.leastLimitRadius = radiusOf(result.packing.farLimit);
}
} // namespace

const char *
NameOf(ConformalType type)
{
  return type == ConformalType::Parabolic    ? "parabolic"
         : type == ConformalType::Hyperbolic ? "hyperbolic"
                                             : "not decided";
}

TypeEvidence
JudgeGrowth(const std::vector<double> & radii, const std::vector<double> & quantities)
{
  constexpr std::size_t least = 3; // slopes for a fit with a residual
  TypeEvidence          evidence{ ConformalType::NotDecided, NotANumber, NotANumber, NotANumber };
  const std::size_t     slopes = radii.empty() ? 0 : radii.size() - 1;
  if (slopes < least)
  {
    return evidence;
  }
  const std::size_t number = std::max(least, (slopes + 1) / 2);
  double            sums[] = { 0.0, 0.0, 0.0, 0.0 }; // of x, y, x^2 and xy
  double            last = 0.0;
  for (std::size_t i = slopes - number; i < slopes; ++i)
  {
    const double step = std::log(radii[i + 1] / radii[i]);
    const double slope = (quantities[i + 1] - quantities[i]) / step;
    if (!(slope > 0.0))
    {
      return evidence; // no growth law
    }
    const double x = std::log(std::sqrt(radii[i + 1] * radii[i]));
    const double y = std::log(slope);
    sums[0] += x;
    sums[1] += y;
    sums[2] += x * x;
    sums[3] += x * y;
    last = slope;
  }
  const auto n = static_cast<double>(number);
  evidence.decay = -(n * sums[3] - sums[0] * sums[1]) / (n * sums[2] - sums[0] * sums[0]);
  if (evidence.decay <= mostDecayOfParabolic)
  {
    evidence.type = ConformalType::Parabolic;
    evidence.limit = evidence.farLimit = std::numeric_limits<double>::infinity();
  }
  else if (evidence.decay >= leastDecayOfHyperbolic)
  {
    evidence.type = ConformalType::Hyperbolic;
    evidence.farLimit = quantities[slopes] + last / evidence.decay;
    evidence.limit = std::min(evidence.farLimit, quantities[slopes] + GeometricRest(radii, quantities));
  }
  return evidence;
}

ConformalTypeResult
FindConformalType(const Graph & graph, const ConformalTypeSettings & settings)
{
  CheckOptions(settings);
  RequireSound(graph, "the graph");
  RequireParameter(settings.root >= -1 && settings.root < graph.nodes, "the parameter \"root\" is not a node");
  const RootedMap     rooted(graph, settings.root);
  ConformalTypeResult result;
  result.root = rooted.Root();
  const int farthest = rooted.DistanceOfOuterFace();
  const int most = std::min(farthest, settings.maximumRadius.value_or(farthest));
  for (const int radius : RadiiUpTo(most))
  {
    if (result.balls.empty() || radius > result.balls.back().radius) // otherwise the same ball
    {
      settings.progress("Packing balls", static_cast<double>(radius - 1) / most * (radius - 1) / most);
      result.balls.push_back(Measured(BallAround(rooted, radius)));
    }
  }
  Conclude(result);
  return result;
}

ConformalTypeResult
FindConformalType(const std::vector<Graph> & graphs, const std::vector<int> & roots, const Progress & progress)
{
  if (graphs.size() != roots.size() || graphs.empty())
  {
    throw std::invalid_argument("each graph needs a root");
  }
  ConformalTypeResult result;
  result.root = roots.front();
  for (std::size_t i = 0; i < graphs.size(); ++i)
  {
    progress("Packing balls", static_cast<double>(i) / static_cast<double>(graphs.size()));
    RequireSound(graphs[i], "graph " + std::to_string(i + 1));
    const BallMap disk = WholeDisk(RootedMap(graphs[i], roots[i]));
    if (!result.balls.empty() && disk.radius <= result.balls.back().radius)
    {
      throw InputError("graph " + std::to_string(i + 1) + " of the sequence has radius " + std::to_string(disk.radius) +
                       " around the root, not more than the graph before it");
    }
    result.balls.push_back(Measured(disk));
  }
  Conclude(result);
  return result;
}
} // namespace shapeton
