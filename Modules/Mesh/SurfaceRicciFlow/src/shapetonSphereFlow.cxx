#include "shapetonSphereFlow.h"

#include "shapetonCurvatureNewton.h"
#include "shapetonDevelopment.h"
#include "shapetonExceptions.h"
#include "shapetonPi.h"
#include "shapetonTrianglesOfGeometry.h"

#include <algorithm>
#include <set>

namespace shapeton
{
namespace
{
/** Stricter than for other metrics, because small faces near the vertex at infinity magnify errors. */
constexpr RicciTolerance planeTolerance{ 1e-13, 1e-10 };
/** Vertices tried at infinity. The first is usually good. */
constexpr std::size_t mostCandidates = 20;
constexpr int         mostRounds = 100; // of flips at the vertex at infinity; 1 to 3 are usual

/** Sides that start at a vertex. */
std::vector<int>
SidesFrom(const IntrinsicTriangulation & triangulation, int vertex)
{
  std::vector<int> sides;
  for (int side = 0; side < triangulation.NumberOfSides(); ++side)
  {
    if (triangulation.Origin(side) == vertex)
    {
      sides.push_back(side);
    }
  }
  return sides;
}

/** Number of edges from each vertex to the nearest of the given vertices. */
std::vector<int>
StepsFrom(const IntrinsicTriangulation & triangulation, std::vector<int> vertices)
{
  std::vector<std::vector<int>> neighbors(triangulation.NumberOfVertices());
  for (int side = 0; side < triangulation.NumberOfSides(); ++side)
  {
    neighbors[triangulation.Origin(side)].push_back(triangulation.End(side));
  }
  std::vector<int> steps(neighbors.size(), -1);
  for (const int v : vertices)
  {
    steps[v] = 0;
  }
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    for (const int other : neighbors[vertices[i]])
    {
      if (steps[other] == -1)
      {
        steps[other] = steps[vertices[i]] + 1;
        vertices.push_back(other);
      }
    }
  }
  return steps;
}

/** Three vertices far from each other. */
std::vector<int>
ThreeFarVertices(const IntrinsicTriangulation & triangulation)
{
  std::vector<int> vertices{ 0 };
  for (int i = 0; i < 3; ++i)
  {
    const std::vector<int> steps = StepsFrom(triangulation, vertices);
    const int              farthest = static_cast<int>(std::max_element(steps.begin(), steps.end()) - steps.begin());
    i == 0 ? vertices[0] = farthest : (vertices.push_back(farthest), farthest);
  }
  return vertices;
}

/** A flat metric with three cones of curvature 4 pi / 3, the surface of a doubled triangle. It always exists. The
 * triangulation and the coordinates become those of this metric; returns u. */
RicciSolution
FlowToCones(IntrinsicTriangulation & triangulation,
            Eigen::VectorXd &        coordinates,
            const std::vector<int> & cones,
            const Progress &         progress,
            int &                    flips)
{
  RicciUnknowns unknowns;
  unknowns.angles = Eigen::VectorXd::Constant(triangulation.NumberOfVertices(), TwoPi);
  unknowns.isFixed.assign(triangulation.NumberOfVertices(), 0);
  unknowns.gauge = 0;
  for (int v = 0; v < triangulation.NumberOfVertices(); ++v)
  {
    unknowns.ofVertices.push_back(v);
  }
  for (const int v : cones)
  {
    unknowns.angles[v] = TwoPi / 3.0;
  }
  ConformalMetric     metric(triangulation, coordinates, RicciScheme::VertexScaling, RicciGeometry::Euclidean);
  const RicciSolution solution = SolveForCurvature(
    metric, unknowns, Eigen::VectorXd::Zero(triangulation.NumberOfVertices()), planeTolerance, progress);
  triangulation = metric.Triangulation();
  coordinates = metric.Lengths();
  flips = static_cast<int>(metric.Flips().size());
  return solution;
}

/** Vertices with distinct neighbors and not close to the cones, sorted by the worst face shape at each vertex, best
 * first. */
std::vector<int>
CandidatesForInfinity(const IntrinsicTriangulation & triangulation,
                      const Eigen::VectorXd &        lengths,
                      const std::vector<int> &       cones)
{
  const std::vector<int>     steps = StepsFrom(triangulation, cones);
  const int                  farthest = *std::max_element(steps.begin(), steps.end());
  std::vector<double>        quality(triangulation.NumberOfVertices(), 1.0);
  std::vector<std::set<int>> neighbors(quality.size());
  std::vector<std::size_t>   degrees(quality.size(), 0);
  for (int side = 0; side < triangulation.NumberOfSides(); ++side)
  {
    const int    face = side - side % 3;
    const double a = lengths[triangulation.EdgeOf(face)], b = lengths[triangulation.EdgeOf(face + 1)],
                 c = lengths[triangulation.EdgeOf(face + 2)];
    const int v = triangulation.Origin(side);
    quality[v] = std::min(quality[v], (b + c - a) * (c + a - b) * (a + b - c) / (a * b * c));
    neighbors[v].insert(triangulation.End(side));
    ++degrees[v];
  }
  std::vector<int> candidates;
  for (int v = 0; v < triangulation.NumberOfVertices(); ++v)
  {
    if (neighbors[v].size() == degrees[v] && neighbors[v].count(v) == 0 && 2 * steps[v] >= farthest)
    {
      candidates.push_back(v);
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(), [&](int a, int b) { return quality[a] > quality[b]; });
  candidates.resize(std::min(candidates.size(), mostCandidates));
  return candidates;
}

/** Flat metric of the faces that do not touch the vertex at infinity. */
struct FlatPart
{
  std::vector<int> keptFaces, keptEdges;
  RicciSolution    solution;
  int              flips{ 0 };
  Eigen::VectorXd  angleSums;
  Eigen::VectorXcd places; ///< for each vertex
};

FlatPart
FlattenAround(IntrinsicTriangulation & triangulation,
              Eigen::VectorXd &        coordinates,
              int                      infinity,
              Eigen::VectorXd          start,
              const Progress &         progress)
{
  FlatPart               part;
  IntrinsicTriangulation rest = triangulation.WithoutStar(infinity, part.keptFaces, part.keptEdges);
  Eigen::VectorXd        kept(part.keptEdges.size());
  for (std::size_t e = 0; e < part.keptEdges.size(); ++e)
  {
    kept[static_cast<Eigen::Index>(e)] = coordinates[part.keptEdges[e]];
  }
  RicciUnknowns unknowns;
  unknowns.angles = Eigen::VectorXd::Constant(start.size(), TwoPi);
  unknowns.isFixed.assign(start.size(), 0);
  unknowns.isFixed[infinity] = 1;
  for (int v = 0; v < rest.NumberOfVertices(); ++v)
  {
    unknowns.ofVertices.push_back(v);
  }
  for (const int side : SidesFrom(triangulation, infinity))
  {
    const int v = triangulation.End(side);
    unknowns.isFixed[v] = 1;
    start[v] = -2.0 * std::log(coordinates[triangulation.EdgeOf(side)]);
  }
  ConformalMetric metric(rest, kept, RicciScheme::VertexScaling, RicciGeometry::Euclidean);
  part.solution = SolveForCurvature(metric, unknowns, start, planeTolerance, progress);
  part.angleSums = metric.AngleSums();
  part.flips = static_cast<int>(metric.Flips().size());
  for (const int side : metric.Flips())
  {
    const int original = 3 * part.keptFaces[side / 3] + side % 3;
    coordinates[triangulation.EdgeOf(original)] = PtolemyDiagonal(triangulation, coordinates, original);
    triangulation.Flip(original);
  }
  const auto                    charts = ChartsOfFaces(metric.Triangulation(), metric.Lengths(), metric.Geometry());
  const std::vector<char>       isCut(metric.Triangulation().NumberOfEdges(), 0);
  const std::vector<PlanePoint> places =
    LayOutFaces(metric.Triangulation(), charts, isCut, metric.Geometry(), InnermostFace(metric.Triangulation(), isCut));
  part.places = Eigen::VectorXcd::Zero(start.size());
  for (int side = 0; side < metric.Triangulation().NumberOfSides(); ++side)
  {
    part.places[metric.Triangulation().Origin(side)] = places[side];
  }
  return part;
}

/** Flips the edges from infinity to concave neighbors. Returns whether there were any. */
bool
FlipConcaveNeighbors(IntrinsicTriangulation & triangulation,
                     Eigen::VectorXd &        coordinates,
                     int                      infinity,
                     const Eigen::VectorXd &  angleSums)
{
  constexpr double rounding = 1e-9; // radians
  bool             isFlipped = false;
  std::size_t      degree = SidesFrom(triangulation, infinity).size();
  for (bool goesOn = true; goesOn && degree > 3;)
  {
    goesOn = false;
    for (const int side : SidesFrom(triangulation, infinity))
    {
      if (angleSums[triangulation.End(side)] > Pi + rounding && degree > 3)
      {
        coordinates[triangulation.EdgeOf(side)] = PtolemyDiagonal(triangulation, coordinates, side);
        triangulation.Flip(side);
        --degree;
        goesOn = isFlipped = true;
        break;
      }
    }
  }
  return isFlipped;
}

/** A flat metric whose vertex at infinity has convex neighbors. */
struct FlatSphere
{
  IntrinsicTriangulation triangulation;
  Eigen::VectorXd        coordinates;
  FlatPart               part;
  int                    infinity{ -1 };
};

/** Flattens the triangulation without the vertex at infinity until the neighbors of that vertex are convex. Throws
 * InputError if this fails. Adds steps and flips. */
void
Unfold(FlatSphere & flat, const Progress & progress, SpherePolyhedron & count)
{
  Eigen::VectorXd start = Eigen::VectorXd::Constant(
    flat.triangulation.NumberOfVertices(),
    -2.0 * std::log(flat.coordinates[flat.triangulation.EdgeOf(SidesFrom(flat.triangulation, flat.infinity).front())]));
  for (int round = 0; round < mostRounds; ++round)
  {
    flat.part = FlattenAround(flat.triangulation, flat.coordinates, flat.infinity, start, progress);
    count.steps += flat.part.solution.steps;
    count.flips += flat.part.flips;
    start = flat.part.solution.u;
    if (!FlipConcaveNeighbors(flat.triangulation, flat.coordinates, flat.infinity, flat.part.angleSums))
    {
      return;
    }
  }
  throw InputError("the neighbors of the vertex at infinity are not convex");
}

/** Unfold() for the first vertex at infinity with which it succeeds. */
FlatSphere
UnfoldAround(const std::vector<int> & candidates,
             const FlatSphere &       start,
             const Progress &         progress,
             SpherePolyhedron &       count)
{
  std::string reason = "no vertex has distinct neighbors";
  for (const int infinity : candidates)
  {
    FlatSphere flat = start;
    flat.infinity = infinity;
    try
    {
      Unfold(flat, progress, count);
      return flat;
    }
    catch (const InputError & error)
    {
      reason = error.what();
    }
  }
  throw InputError("no spherical metric was found: " + reason);
}

/** Boosts the sphere until the weighted mean is 0, and updates the chord scales. */
void
CenterSphere(const Eigen::VectorXd & weights, VertexMatrix & places, Eigen::VectorXd & logScales)
{
  constexpr int    mostBoosts = 1000;
  constexpr double fastest = 0.6, centered = 1e-13;
  const double     total = weights.sum();
  for (int i = 0; i < mostBoosts; ++i)
  {
    const Eigen::RowVector3d mean = weights.transpose() * places / total;
    if (mean.norm() < centered)
    {
      return;
    }
    // Exact to first order for a uniform distribution, whose mean moves by 2/3 of the boost.
    const double             speed = std::min(fastest, 1.5 * mean.norm());
    const Eigen::RowVector3d along = mean.normalized();
    const double             gamma = 1.0 / std::sqrt(1.0 - speed * speed);
    for (Eigen::Index v = 0; v < places.rows(); ++v)
    {
      const double x = places.row(v).dot(along);
      const double time = gamma * (1.0 - speed * x);
      places.row(v) = (places.row(v) + ((gamma - 1.0) * x - gamma * speed) * along) / time;
      places.row(v).normalize();
      logScales[v] -= std::log(time);
    }
  }
}

/** Stereographic projection of the plane, scaled and moved so that the sphere is roughly centered. */
void
Project(const FlatSphere & flat, const Eigen::VectorXd & weights, SpherePolyhedron & result)
{
  // Scale the plane by the root of the mean weighted square of the distance from the weighted mean.
  const double    total = weights.sum() - weights[flat.infinity];
  Eigen::VectorXd others = weights;
  others[flat.infinity] = 0.0;
  const std::complex<double> mean = (others.cast<std::complex<double>>().transpose() * flat.part.places)(0) / total;
  const Eigen::VectorXcd     places = flat.part.places.array() - mean;
  const double               scale = std::sqrt(others.dot(places.cwiseAbs2()) / total);
  result.places.resize(places.size(), 3);
  result.logScales.resize(places.size());
  for (Eigen::Index v = 0; v < places.size(); ++v)
  {
    const std::complex<double> z = places[v] / scale;
    const double               square = std::norm(z);
    result.places.row(v) << 2.0 * z.real() / (1.0 + square), 2.0 * z.imag() / (1.0 + square),
      (1.0 - square) / (1.0 + square);
    result.logScales[v] = flat.part.solution.u[v] + std::log(2.0 / scale / (1.0 + square));
  }
  result.places.row(flat.infinity) << 0.0, 0.0, -1.0;
  result.logScales[flat.infinity] = std::log(2.0 * scale);
}
} // namespace

SpherePolyhedron
FlowToSphere(IntrinsicTriangulation & triangulation,
             Eigen::VectorXd          coordinates,
             const Eigen::VectorXd &  weights,
             const Progress &         progress)
{
  constexpr int          fewestVertices = 5;
  const std::vector<int> cones = ThreeFarVertices(triangulation);
  if (triangulation.NumberOfVertices() < fewestVertices)
  {
    throw InputError("the surface has too few vertices for a spherical metric");
  }
  // First a metric that always exists: in it, the neighborhood of the vertex at infinity is flat and Delaunay, and an
  // inversion there makes its neighbors convex.
  SpherePolyhedron    result;
  const RicciSolution onCones =
    FlowToCones(triangulation, coordinates, cones, progress.Part("", 0.0, 0.5), result.flips);
  result.steps = onCones.steps;
  const FlatSphere flat = UnfoldAround(CandidatesForInfinity(triangulation, coordinates, cones),
                                       { triangulation, coordinates, {}, -1 },
                                       progress.Part("", 0.5, 1.0),
                                       result);
  triangulation = flat.triangulation;
  Project(flat, weights, result);
  CenterSphere(weights, result.places, result.logScales);
  result.chords.resize(coordinates.size());
  for (int e = 0; e < triangulation.NumberOfEdges(); ++e)
  {
    const int side = triangulation.SideOf(e);
    result.chords[e] =
      flat.coordinates[e] *
      std::exp(0.5 * (result.logScales[triangulation.Origin(side)] + result.logScales[triangulation.End(side)]));
  }
  result.logScales += onCones.u;
  return result;
}
} // namespace shapeton
