#include "shapetonSlitMap.h"

#include "shapetonBoundedWeights.h"
#include "shapetonConjugateFunction.h"
#include "shapetonExceptions.h"
#include "shapetonPi.h"
#include "shapetonTubeCut.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Cost of winding around, relative to the radial path length. */
constexpr double sideways = 20.0;
/** Cost of touching a vertex that the cut should avoid. */
constexpr double detour = 1000.0;
constexpr int    ringsAroundSaddles = 3;

/** Sum of a function over the vertices of each loop. */
Eigen::VectorXd
SumsOfLoops(const std::vector<BoundaryLoop> & loops, const Eigen::VectorXd & x)
{
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(loops.size()));
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    for (const int vertex : loops[i].vertices)
    {
      sums[static_cast<Eigen::Index>(i)] += x[vertex];
    }
  }
  return sums;
}

std::vector<int>
InnerOf(const std::vector<BoundaryLoop> & loops, int outer)
{
  if (loops.size() < 2)
  {
    throw InputError("a slit map requires an outer and at least one inner boundary; the surface has " +
                     std::to_string(loops.size()) + (loops.size() == 1 ? " boundary" : " boundaries"));
  }
  if (outer < 0 || outer >= static_cast<int>(loops.size()))
  {
    throw InputError("boundary " + std::to_string(outer + 1) +
                     ", chosen as the outer boundary, does not exist; there are " + std::to_string(loops.size()));
  }
  std::vector<int> inner;
  for (int i = 0; i < static_cast<int>(loops.size()); ++i)
  {
    if (i != outer)
    {
      inner.push_back(i);
    }
  }
  return inner;
}

/** The vertices of all loops, one loop after the other. */
std::vector<int>
VerticesOfLoops(const std::vector<BoundaryLoop> & loops)
{
  std::vector<int> vertices;
  for (const BoundaryLoop & loop : loops)
  {
    vertices.insert(vertices.end(), loop.vertices.begin(), loop.vertices.end());
  }
  return vertices;
}

/** Loop values of the functions that are 1 on one inner loop and 0 on all others. */
Eigen::MatrixXd
ValuesOfLoops(const std::vector<BoundaryLoop> & loops, const std::vector<int> & innerLoops)
{
  const std::size_t count = VerticesOfLoops(loops).size();
  Eigen::MatrixXd   values =
    Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(innerLoops.size()));
  Eigen::Index first = 0;
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    const auto length = static_cast<Eigen::Index>(loops[i].vertices.size());
    const auto place = std::find(innerLoops.begin(), innerLoops.end(), static_cast<int>(i));
    if (place != innerLoops.end())
    {
      values.col(place - innerLoops.begin()).segment(first, length).setOnes();
    }
    first += length;
  }
  return values;
}
} // namespace

struct SlitMapSolver::State
{
  /** Harmonic functions of all inner loops and their fluxes. \equation{5.12} */
  State(const SurfaceMesh &         surface,
        const SurfaceConnectivity & itsConnectivity,
        const Eigen::VectorXd &     edgeLengths,
        std::vector<BoundaryLoop>   itsLoops,
        int                         outerLoop,
        const std::vector<int> &    weightLevels,
        const Progress &            progress)
    : F(surface.F)
    , connectivity(itsConnectivity)
    , spaceLengths(EdgeLengths(itsConnectivity, surface.V))
    , loops(std::move(itsLoops))
    , outer(outerLoop)
    , innerLoops(InnerOf(loops, outer))
    , laplacian(WithBoundedWeights(MakeSurfaceLaplacian(itsConnectivity, edgeLengths), weightLevels))
    , stiffness(StiffnessMatrix(laplacian))
    , graph(itsConnectivity)
  {
    const SymbolicFactorization symbolic = HarmonicSolver::Analyze(itsConnectivity);
    progress(0.4);
    const HarmonicSolver solver(laplacian, VerticesOfLoops(loops), symbolic, progress.Part("", 0.4, 0.6));
    functions = solver.Solve(ValuesOfLoops(loops, innerLoops));
    progress(0.8);
    angleSolver = std::make_unique<HarmonicSolver>(
      laplacian, std::vector<int>{ loops[outer].vertices[0] }, symbolic, progress.Part("", 0.8, 1.0));
    const Eigen::MatrixXd fluxes = functions.transpose() * (stiffness * functions);
    P = 0.5 * (fluxes + fluxes.transpose());
  }

  /** Cuts along the cheapest path that avoids other boundaries, and saddles, which occur at handles. Computes
   * the angle and returns its energy. */
  double
  ComputeAngle(Eigen::VectorXd edgeCosts, const std::vector<char> & isAvoided, SlitMap & map) const
  {
    for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
    {
      const auto & [a, b] = connectivity.VerticesOfEdge(edge);
      edgeCosts[edge] *= isAvoided[a] || isAvoided[b] ? detour : 1.0;
    }
    map.cut = CheapestPath(graph, { loops[outer].vertices, loops[map.inner].vertices }, edgeCosts);
    if (map.cut.empty())
    {
      throw InputError("no path of edges joins boundaries " + std::to_string(outer + 1) + " and " +
                       std::to_string(map.inner + 1));
    }
    map.left = LeftCorners(F, connectivity, map.cut);
    const Eigen::VectorXd turns = SolveWithUnitJump(laplacian, *angleSolver, F, connectivity, map.left);
    map.angle = TwoPi * (turns.array() - turns[loops[outer].vertices.front()]);
    return TwoPi * TwoPi * EnergyOfCorners(laplacian, connectivity, F, LiftedValues(F, turns, map.left));
  }
  std::vector<char>
  PlacesToAvoid(const SlitMap & map) const
  {
    const std::vector<int> saddles = SaddleMultiplicities(F, connectivity, map.logRadius);
    const std::vector<int> loopOf = LoopOfVertices(loops, connectivity.NumberOfVertices());
    std::vector<char>      isAvoided(saddles.size());
    std::transform(saddles.begin(), saddles.end(), isAvoided.begin(), [](int saddle) { return saddle > 0; });
    Dilate(graph, isAvoided, ringsAroundSaddles);
    for (std::size_t v = 0; v < loopOf.size(); ++v)
    {
      isAvoided[v] =
        (isAvoided[v] && loopOf[v] == -1) || (loopOf[v] != -1 && loopOf[v] != outer && loopOf[v] != map.inner);
    }
    return isAvoided;
  }
  /** Angular extent of each edge. */
  Eigen::VectorXd
  AngleSteps(const SlitMap & map) const
  {
    Eigen::VectorXd steps(connectivity.NumberOfEdges());
    for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
    {
      const auto & [a, b] = connectivity.VerticesOfEdge(edge);
      steps[edge] = std::abs(std::remainder(map.angle[a] - map.angle[b], TwoPi));
    }
    return steps;
  }

  FaceMatrix                      F;
  SurfaceConnectivity             connectivity;
  Eigen::VectorXd                 spaceLengths;
  std::vector<BoundaryLoop>       loops;
  int                             outer;
  std::vector<int>                innerLoops;
  SurfaceLaplacian                laplacian;
  Eigen::SparseMatrix<double>     stiffness;
  Eigen::MatrixXd                 functions;
  Eigen::MatrixXd                 P;
  EdgeGraph                       graph;
  std::unique_ptr<HarmonicSolver> angleSolver;
};

SlitMapSolver::SlitMapSolver(const SurfaceMesh &         mesh,
                             const SurfaceConnectivity & connectivity,
                             const Eigen::VectorXd &     edgeLengths,
                             std::vector<BoundaryLoop>   loops,
                             int                         outer,
                             const std::vector<int> &    weightLevels,
                             const Progress &            progress)
  : m_State(
      std::make_unique<const State>(mesh, connectivity, edgeLengths, std::move(loops), outer, weightLevels, progress))
{}

SlitMapSolver::~SlitMapSolver() = default;

/** \equation{5.16} as a system for `lambda`. */
SlitMap
SlitMapSolver::Map(int inner, const Progress & progress) const
{
  const State & s = *m_State;
  const auto    place = std::find(s.innerLoops.begin(), s.innerLoops.end(), inner);
  if (place == s.innerLoops.end())
  {
    throw InputError("boundary " + std::to_string(inner + 1) + " is not an inner one; choose another");
  }
  const auto            k = static_cast<Eigen::Index>(place - s.innerLoops.begin());
  const auto            n = static_cast<Eigen::Index>(s.innerLoops.size());
  SlitMap               map;
  const Eigen::VectorXd lambda = s.P.ldlt().solve(TwoPi * Eigen::VectorXd::Unit(n, k));
  map.inner = inner;
  map.logRadius = -(s.functions * lambda);
  map.logRadiusOfLoops = Eigen::VectorXd::Zero(n + 1);
  for (Eigen::Index j = 0; j < n; ++j)
  {
    map.logRadiusOfLoops[s.innerLoops[j]] = -lambda[j];
  }
  map.turnsOfLoops = SumsOfLoops(s.loops, s.stiffness * map.logRadius) / TwoPi;
  const std::vector<char> isAvoided = s.PlacesToAvoid(map);
  progress(0.3);
  s.ComputeAngle(s.spaceLengths, isAvoided, map);
  progress(0.6);
  const double radius = s.loops[s.outer].length / TwoPi;
  const double energy = s.ComputeAngle(s.spaceLengths + sideways * radius * s.AngleSteps(map), isAvoided, map);
  map.modulusU = TwoPi / lambda[k];
  map.modulusV = TwoPi * TwoPi / energy;
  progress(1.0);
  return map;
}

const Eigen::MatrixXd &
SlitMapSolver::HarmonicFunctions() const
{
  return m_State->functions;
}

const Eigen::MatrixXd &
SlitMapSolver::Fluxes() const
{
  return m_State->P;
}

const std::vector<int> &
SlitMapSolver::InnerLoops() const
{
  return m_State->innerLoops;
}

const std::vector<BoundaryLoop> &
SlitMapSolver::Loops() const
{
  return m_State->loops;
}

int
SlitMapSolver::OuterLoop() const
{
  return m_State->outer;
}
} // namespace shapeton
