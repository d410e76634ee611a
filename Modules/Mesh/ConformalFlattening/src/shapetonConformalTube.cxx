#include "shapetonConformalTube.h"

#include "shapetonBoundedWeights.h"
#include "shapetonConjugateFunction.h"
#include "shapetonHandleLoops.h"
#include "shapetonHarmonicSolver.h"
#include "shapetonParallelFor.h"
#include "shapetonTubeCut.h"
#include "shapetonTubeSolver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace shapeton
{
namespace
{
/** Deviation from the line v = 0 that doubles the path cost, as a fraction of the circumference. */
constexpr double deviation = 1.0 / 12.0;
/** Half-width of the first search band, as a fraction of the circumference. */
constexpr double band = 0.15;
/** Vertices with a larger angle defect (radians) belong to flipped or singular faces. */
constexpr double leastDefect = 1e-6;

/** Values at the vertices of the ends: 0 on the first loop, 1 on the second. */
Eigen::MatrixXd
EndValues(const TubeEnds & ends)
{
  Eigen::MatrixXd values(ends.first.size() + ends.second.size(), 1);
  values.topRows(ends.first.size()).setZero();
  values.bottomRows(ends.second.size()).setOnes();
  return values;
}

} // namespace

/** State of one map, from metric to rectangle. */
class TubeSolver::Flattening
{
public:
  Flattening(const SurfaceMesh &         mesh,
             const SurfaceConnectivity & connectivity,
             const Eigen::VectorXd &     edgeLengths,
             const TubeEnds &            ends,
             const TubeOptions &         options)
    : m_Mesh(mesh), m_Connectivity(connectivity), m_MetricLengths(edgeLengths), m_Ends(ends), m_Options(options)
  {
    this->Prepare();
  }

  TubeMap
  Run(const Progress & progress)
  {
    m_Map = {};
    m_IsAvoided.clear();
    progress(0.0);
    this->Factorize(progress.Part("", 0.0, 0.5));
    m_Map.u = m_Along->Solve(EndValues(m_Ends)).col(0);
    m_Map.modulusU = GradientEnergy(m_Laplacian, m_Map.u);
    m_Along.reset();
    progress(0.55);
    m_Map.cutPath = this->FirstPath();
    progress(0.6);
    if (m_Options.conjugate == TubeConjugate::Published)
    {
      this->SumAlongTree();
    }
    else
    {
      this->SolveConjugate(progress.Part("", 0.6, 0.9));
    }
    progress(0.9);
    this->MakeFlat();
    progress(1.0);
    return std::move(m_Map);
  }

  /** \param levels vertex levels for BoundedWeights(). */
  void
  BoundWeights(const std::vector<int> & levels)
  {
    m_Solved.weights = BoundedWeights(m_Laplacian, levels);
  }

private:
  /** Symbolic analysis, run in parallel with the Laplacian. */
  void
  Prepare()
  {
    ParallelFor(2, [&](std::size_t i) {
      if (i == 0)
      {
        m_Symbolic = HarmonicSolver::Analyze(m_Connectivity);
      }
      else
      {
        m_Laplacian = MakeSurfaceLaplacian(m_Connectivity, m_MetricLengths);
        m_Graph = EdgeGraph(m_Connectivity);
        m_Lengths = EdgeLengths(m_Connectivity, m_Mesh.V);
      }
    });
    m_Solved = m_Laplacian;
  }

  void
  Factorize(const Progress & progress)
  {
    m_Along = std::make_unique<HarmonicSolver>(m_Solved, m_Ends.Vertices(), *m_Symbolic, progress.Part("", 0.0, 0.5));
    if (m_Options.conjugate == TubeConjugate::Laplacian)
    {
      m_Around = std::make_unique<HarmonicSolver>(
        m_Solved, std::vector<int>{ m_Ends.first[0] }, *m_Symbolic, progress.Part("", 0.5, 1.0));
    }
  }

  /** Costs of edges near vertices that the cut avoids. */
  void
  Avoid(std::vector<char> isAvoided, int rings, Eigen::VectorXd & costs) const
  {
    Dilate(m_Graph, isAvoided, rings);
    for (int edge = 0; edge < m_Connectivity.NumberOfEdges(); ++edge)
    {
      const auto & ends = m_Connectivity.VerticesOfEdge(edge);
      costs[edge] *= isAvoided[ends[0]] || isAvoided[ends[1]] ? m_Options.saddleCost : 1.0;
    }
  }

  std::vector<int>
  FirstPath()
  {
    const std::vector<int> multiplicities = SaddleMultiplicities(m_Mesh.F, m_Connectivity, m_Map.u);
    for (const int multiplicity : multiplicities)
    {
      m_IsAvoided.push_back(multiplicity > 0);
      m_Map.saddles += std::max(0, multiplicity);
    }
    this->AvoidHandles();
    const bool isFinal = m_Options.conjugate == TubeConjugate::Published || !m_Options.cutCurve.empty();
    if (m_Map.saddles == 0 && !isFinal)
    {
      // Without handles any path works; the cut is recomputed once v is known.
      const std::vector<int> path = AscendingPath(m_Graph, m_Ends, m_Map.u);
      if (!path.empty())
      {
        return path;
      }
    }
    Eigen::VectorXd costs = m_Lengths;
    if (!m_Options.cutCurve.empty())
    {
      const Eigen::VectorXd distances = DistancesFromCurve(m_Mesh, m_Graph, m_Lengths, m_Options.cutCurve);
      constexpr double      costOfAway = 10.0; // at a distance of one mean edge from the curve
      const double          scale = 0.5 / m_Lengths.mean();
      for (Eigen::Index edge = 0; edge < costs.size(); ++edge)
      {
        const auto & ends = m_Connectivity.VerticesOfEdge(static_cast<int>(edge));
        const double away = scale * (distances[ends[0]] + distances[ends[1]]);
        costs[edge] *= 1.0 + costOfAway * away * away;
      }
    }
    if (m_Map.saddles > 0)
    {
      this->Avoid(m_IsAvoided, m_Options.saddleRings, costs);
      AvoidShortcuts(m_Mesh, m_Connectivity, m_Lengths, costs);
    }
    return CheapestPath(m_Graph, m_Ends, costs);
  }

  /** A cut through a handle crosses its loop. */
  void
  AvoidHandles()
  {
    for (const HandleLoop & loop : this->HandleLoops())
    {
      for (const int vertex : loop.vertices)
      {
        m_IsAvoided[vertex] = 1;
      }
    }
  }

  /** Computed once: all maps are of the same surface. */
  const std::vector<HandleLoop> &
  HandleLoops()
  {
    if (!m_HandleLoops)
    {
      m_HandleLoops = FindHandleLoops(m_Mesh, m_Connectivity);
    }
    return *m_HandleLoops;
  }

  double
  MeanOnPath(const Eigen::VectorXd & values) const
  {
    double sum = 0.0;
    for (const int vertex : m_Map.cutPath)
    {
      sum += values[vertex];
    }
    return sum / static_cast<double>(m_Map.cutPath.size());
  }

  void
  SolveConjugate(const Progress & progress)
  {
    const std::vector<int> left = LeftCorners(m_Mesh.F, m_Connectivity, m_Map.cutPath);
    Eigen::VectorXd        v = SolveWithUnitJump(m_Solved, *m_Around, m_Mesh.F, m_Connectivity, left);
    m_Around.reset();
    progress(0.4);
    v.array() -= this->MeanOnPath(v);
    const CornerValues lifted = LiftedValues(m_Mesh.F, v, left);
    m_Map.modulusV = 1.0 / EnergyOfCorners(m_Laplacian, m_Connectivity, m_Mesh.F, lifted);
    progress(0.5);
    if (m_Options.cutCurve.empty() && this->CutAlongLine(v, lifted, progress.Part("", 0.5, 1.0)))
    {
      return;
    }
    m_Cut = CutAlongPaths(m_Mesh, m_Connectivity, { m_Map.cutPath });
    m_V = this->ValuesOfCut(lifted);
  }

  /** Vertex values of a function that is continuous on the cut surface. */
  Eigen::VectorXd
  ValuesOfCut(const CornerValues & lifted) const
  {
    Eigen::VectorXd values(m_Cut.mesh.V.rows());
    for (Eigen::Index corner = 0; corner < m_Cut.mesh.F.size(); ++corner)
    {
      values[m_Cut.mesh.F.data()[corner]] = lifted[corner];
    }
    return values;
  }

  /** Moves the cut to v = 0. Returns false and keeps the first path if the two cuts together do not bound a region.
   * They then pass a handle on different sides of its hole, and v would be multivalued. */
  bool
  CutAlongLine(const Eigen::VectorXd & v, const CornerValues & lifted, const Progress & progress)
  {
    const std::vector<int> path = this->PathAlongLine(v, lifted);
    progress(0.3);
    CutSurface cut = CutAlongPaths(m_Mesh, m_Connectivity, { path });
    progress(0.6);
    std::vector<int> turns;
    if (!TurnsOfFaces(m_Mesh.F, m_Connectivity, cut, lifted, turns))
    {
      return false;
    }
    m_Map.cutPath = path;
    m_Cut = std::move(cut);
    m_V.resize(m_Cut.mesh.V.rows());
    for (Eigen::Index corner = 0; corner < m_Cut.mesh.F.size(); ++corner)
    {
      m_V[m_Cut.mesh.F.data()[corner]] = lifted[corner] + turns[corner / 3];
    }
    m_V.array() -= std::floor(m_V.mean());
    return true;
  }

  /** The cheapest path near v = 0, or the overall cheapest if the mesh is too coarse for one. */
  std::vector<int>
  PathInBand(const Eigen::VectorXd & costs, const Eigen::VectorXd & v) const
  {
    Eigen::VectorXd bounded = costs;
    for (int edge = 0; edge < m_Connectivity.NumberOfEdges(); ++edge)
    {
      const int vertex = m_Connectivity.VerticesOfEdge(edge)[0];
      if (std::abs(v[vertex] - std::round(v[vertex])) > band)
      {
        bounded[edge] = std::numeric_limits<double>::infinity();
      }
    }
    const std::vector<int> path = CheapestPath(m_Graph, m_Ends, bounded);
    return path.empty() ? CheapestPath(m_Graph, m_Ends, costs) : path;
  }

  std::vector<int>
  PathAlongLine(const Eigen::VectorXd & v, const CornerValues & lifted) const
  {
    Eigen::VectorXd costs = m_Lengths;
    for (int edge = 0; edge < m_Connectivity.NumberOfEdges(); ++edge)
    {
      const auto & ends = m_Connectivity.VerticesOfEdge(edge);
      double       away = 0.0;
      for (const int vertex : ends)
      {
        away += 0.5 * std::abs(v[vertex] - std::round(v[vertex])) / deviation;
      }
      costs[edge] *= 1.0 + away * away;
    }
    if (m_Map.saddles == 0)
    {
      return this->PathInBand(costs, v);
    }
    this->Avoid(m_IsAvoided, m_Options.saddleRings, costs);
    const Eigen::VectorXd defects = FlatAngleDefects(m_Mesh.F, m_Connectivity, this->PlacesOfCorners(lifted));
    std::vector<char>     isSingular(m_Mesh.V.rows(), 0);
    for (Eigen::Index i = 0; i < defects.size(); ++i)
    {
      isSingular[i] = std::abs(defects[i]) > leastDefect;
    }
    this->Avoid(isSingular, 2, costs);
    AvoidShortcuts(m_Mesh, m_Connectivity, m_Lengths, costs);
    return CheapestPath(m_Graph, m_Ends, costs);
  }

  /** Plane coordinates of a map with this v, up to scale. */
  CornerPlaces
  PlacesOfCorners(const CornerValues & lifted) const
  {
    CornerPlaces places(m_Mesh.F.size(), 2);
    const double modulus = std::sqrt(m_Map.modulusU * m_Map.modulusV);
    for (Eigen::Index corner = 0; corner < m_Mesh.F.size(); ++corner)
    {
      places.row(corner) << m_Map.u[m_Mesh.F.data()[corner]], modulus * lifted[corner];
    }
    return places;
  }

  /** The published conjugate, whose period may vary along the cut. */
  void
  SumAlongTree()
  {
    const SideLengths     sides = SidesOfFaces(m_Connectivity, m_MetricLengths);
    const Eigen::VectorXd star = AveragedHodgeStar(m_Mesh.F, m_Connectivity, sides, m_Map.u);
    m_Cut = CutAlongPaths(m_Mesh, m_Connectivity, { m_Map.cutPath });
    m_V = IntegrateAlongTree(m_Cut, m_Connectivity, star);
    std::vector<char> isOnLeft(m_Cut.sourcePointId.size(), 0);
    for (const int corner : m_Cut.leftCorners[0])
    {
      isOnLeft[m_Cut.mesh.F.data()[corner]] = 1;
    }
    double ofLeft = 0.0;
    double ofRight = 0.0;
    int    number = 0;
    for (std::size_t i = 0; i < m_Cut.sourcePointId.size(); ++i)
    {
      const int source = m_Cut.sourcePointId[i];
      if (source == static_cast<int>(i))
      {
        continue;
      }
      // The copy is on one side, the vertex itself on the other.
      const bool isLeft = isOnLeft[i] != 0;
      ofLeft += m_V[isLeft ? static_cast<int>(i) : source];
      ofRight += m_V[isLeft ? source : static_cast<int>(i)];
      ++number;
    }
    m_Map.modulusV = (ofLeft - ofRight) / number;
    m_V = (m_V.array() - ofRight / number) / m_Map.modulusV;
  }

  void
  MakeFlat()
  {
    m_Map.circumference = MeanLevelLength(m_Mesh, m_Map.u);
    m_Map.length = m_Map.circumference / std::sqrt(m_Map.modulusU * m_Map.modulusV);
    Eigen::MatrixX2d uv(m_V.size(), 2);
    for (Eigen::Index i = 0; i < m_V.size(); ++i)
    {
      uv.row(i) << m_Map.length * m_Map.u[m_Cut.sourcePointId[i]], m_Map.circumference * m_V[i];
    }
    m_Map.flat = MakeFlatSurface(std::move(m_Cut), uv);
    SetFlatExtent(m_Map.flat, m_Map.circumference, m_Map.length);
  }

  const SurfaceMesh &                  m_Mesh;
  const SurfaceConnectivity &          m_Connectivity;
  const Eigen::VectorXd &              m_MetricLengths;
  const TubeEnds &                     m_Ends;
  const TubeOptions &                  m_Options;
  std::optional<SymbolicFactorization> m_Symbolic;
  SurfaceLaplacian                     m_Laplacian; ///< metric of the map
  SurfaceLaplacian                     m_Solved;    ///< with the weights of the solved system
  EdgeGraph                            m_Graph;
  Eigen::VectorXd                      m_Lengths; ///< in space
  std::unique_ptr<HarmonicSolver>      m_Along;
  std::unique_ptr<HarmonicSolver>      m_Around;
  /** Vertices that the cut avoids: saddles of u, and loops that it would cross on its way through a handle. */
  std::vector<char>                      m_IsAvoided;
  std::optional<std::vector<HandleLoop>> m_HandleLoops;
  CutSurface                             m_Cut;
  Eigen::VectorXd                        m_V; ///< v at the vertices of the cut surface, period 1
  TubeMap                                m_Map;
};

TubeSolver::TubeSolver(const SurfaceMesh &         mesh,
                       const SurfaceConnectivity & connectivity,
                       const Eigen::VectorXd &     edgeLengths,
                       const TubeEnds &            ends,
                       const TubeOptions &         options)
  : m_Flattening(std::make_unique<Flattening>(mesh, connectivity, edgeLengths, ends, options))
{}

TubeSolver::~TubeSolver() = default;

TubeMap
TubeSolver::Solve(const Progress & progress)
{
  return m_Flattening->Run(progress);
}

void
TubeSolver::BoundWeights(const std::vector<int> & levels)
{
  m_Flattening->BoundWeights(levels);
}

TubeMap
FlattenTube(const SurfaceMesh &         mesh,
            const SurfaceConnectivity & connectivity,
            const Eigen::VectorXd &     edgeLengths,
            const TubeEnds &            ends,
            const TubeOptions &         options)
{
  return TubeSolver(mesh, connectivity, edgeLengths, ends, options).Solve(options.progress);
}

Eigen::VectorXd
HarmonicAlongTube(const SurfaceLaplacian & laplacian, const TubeEnds & ends, const Progress & progress)
{
  return HarmonicSolver(laplacian, ends.Vertices(), progress).Solve(EndValues(ends)).col(0);
}
} // namespace shapeton
