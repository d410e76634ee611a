#include "shapetonTubeUnfolding.h"

#include "shapetonBoundedWeights.h"
#include "shapetonOpenEndedProgress.h"
#include "shapetonPouches.h"
#include "shapetonSurfaceHandles.h"
#include "shapetonTubeSolver.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>

namespace shapeton
{
namespace
{
constexpr int mostCuts = 5;          // maximum number of removals
constexpr int ringsAroundHandle = 3; // of faces; flips within them are attributed to the handle
/** On surfaces with handles, the number of maps that do not reduce the flips before another remedy is tried. Flips near
 * handles come and go because their folds change with the weights. */
constexpr int          mostInVain = 2;
constexpr const char * wallPointName = "wallPointId";

using FaceMarks = std::vector<char>;

std::ptrdiff_t
NumberOf(const FaceMarks & marks)
{
  return std::count(marks.begin(), marks.end(), 1);
}

void
RemoveArray(const std::string & name, std::vector<SurfaceArray> & arrays)
{
  const auto isIt = [&](const SurfaceArray & array) { return array.name == name; };
  arrays.erase(std::remove_if(arrays.begin(), arrays.end(), isIt), arrays.end());
}

/** Indices of the remaining vertices; removed ones are dropped. */
std::vector<int>
Renumbered(const std::vector<int> & vertices, const std::vector<int> & kept)
{
  std::vector<int> numbers;
  for (const int vertex : vertices)
  {
    numbers.push_back(static_cast<int>(std::lower_bound(kept.begin(), kept.end(), vertex) - kept.begin()));
  }
  return numbers;
}

/** State of a tube while its folds are removed. */
class TubeUnfolding
{
public:
  TubeUnfolding(SurfaceMesh mesh, const TubeEnds & ends, const TubeMetric & metric, const TubeOptions & options)
    : m_Metric(metric)
    , m_Options(options)
    , m_Steps(options.progress, 1.0)
    , m_MostSolves(options.conjugate == TubeConjugate::Published ? 1 : mostSolves)
  {
    m_Tube.surface = std::move(mesh);
    m_Tube.ends = ends;
    RemoveArray(capName, m_Tube.surface.cellArrays);
    RemoveArray(wallPointName, m_Tube.surface.pointArrays);
    this->Connect();
  }

  UnfoldedTube
  Run()
  {
    bool isDone = this->MapUntilUnfolded(0) || m_Options.conjugate == TubeConjugate::Published;
    for (int round = 0; !isDone && this->FindPouches() && round < mostCuts; ++round)
    {
      this->CutOffPouches();
      isDone = this->MapUntilUnfolded(0);
    }
    isDone = isDone || this->MapUntilUnfolded(1);
    if (!isDone)
    {
      m_Tube.map = std::move(m_Best); // undetected handles fold the map for any weights
    }
    return std::move(m_Tube);
  }

private:
  /** Updates everything that depends on the faces; called after each change of them. */
  void
  Connect()
  {
    m_Connectivity = std::make_unique<SurfaceConnectivity>(m_Tube.surface);
    m_Steps.Step("Metric");
    m_Tube.edgeLengths = m_Metric(m_Tube.surface, *m_Connectivity, m_Steps.NextStep("Metric"));
    m_IsTube = m_Connectivity->Components().front().genus == 0;
    m_FewestFlips = std::numeric_limits<std::ptrdiff_t>::max();
  }

  /** Maps with weights clamped at flipped faces, starting with this level everywhere. Returns false if that does not
   * help, or if invisible pouches must be cut off first. */
  bool
  MapUntilUnfolded(int level)
  {
    TubeSolver       solver(m_Tube.surface, *m_Connectivity, m_Tube.edgeLengths, m_Tube.ends, m_Options);
    std::vector<int> levels(m_Tube.surface.NumberOfVertices(), level);
    std::ptrdiff_t   fewest = std::numeric_limits<std::ptrdiff_t>::max();
    int              solvesInVain = 0;
    for (int solve = 1; solve <= m_MostSolves; ++solve)
    {
      if (level > 0 || solve > 1)
      {
        solver.BoundWeights(levels);
      }
      this->Map(solver);
      const std::ptrdiff_t flips = NumberOf(m_IsFlipped);
      if (flips == 0)
      {
        return true;
      }
      if (flips < m_FewestFlips)
      {
        m_FewestFlips = flips;
        m_Best = m_Tube.map;
      }
      solvesInVain = flips < fewest ? 0 : solvesInVain + 1;
      fewest = std::min(fewest, flips);
      const bool isStuck = !m_IsTube && solvesInVain >= mostInVain;
      if (isStuck || (solve == 1 && level == 0 && NumberOf(this->InvisiblePouches()) > 0))
      {
        return false;
      }
      RaiseWeightLevels(m_Tube.surface.F, EdgeGraph(*m_Connectivity), m_IsFlipped, RingsOfSolve(solve), levels);
    }
    return false;
  }

  /** Computes one map and marks the avoidable flipped faces. */
  void
  Map(TubeSolver & solver)
  {
    m_Tube.map = solver.Solve(m_Steps.NextStep("Flattening"));
    ++m_Tube.solves;
    m_Steps.Step("Flattening");
    const SurfaceMesh & flat = m_Tube.map.flat;
    m_IsFlipped = FlippedFaces(flat.F, FlatCoordinates(flat, "the map"));
    if (!m_IsTube && NumberOf(m_IsFlipped) > 0)
    {
      const HandleDetection found = DetectHandles(*m_Connectivity, flat);
      const FaceMarks       isNear = FacesNearHandles(*m_Connectivity, found.handles, ringsAroundHandle);
      std::transform(m_IsFlipped.begin(), m_IsFlipped.end(), isNear.begin(), m_IsFlipped.begin(), std::greater<>());
    }
  }

  FaceMarks
  InvisiblePouches() const
  {
    const SurfaceMesh & flat = m_Tube.map.flat;
    return this->PouchesOf(InvisibleFaces(m_Tube.surface, *m_Connectivity, flat));
  }

  FaceMarks
  PouchesOf(const FaceMarks & isCore) const
  {
    return FacesOfPouches(m_Tube.surface, *m_Connectivity, m_Tube.map.flat, isCore);
  }

  /** Finds pouches to cut off: invisible ones, else those with flipped faces. Returns whether any exist. */
  bool
  FindPouches()
  {
    m_IsPouch = this->InvisiblePouches();
    if (NumberOf(m_IsPouch) == 0)
    {
      m_IsPouch = this->PouchesOf(m_IsFlipped);
    }
    return NumberOf(m_IsPouch) > 0;
  }

  void
  CutOffPouches()
  {
    m_Steps.Step("Cutting off pouches");
    this->NumberWallPoints();
    CappedSurface capped = shapeton::CutOffPouches(m_Tube.surface, *m_Connectivity, m_IsPouch, m_Tube.caps);
    m_Tube.surface = std::move(capped.mesh);
    m_Tube.caps = std::move(capped.caps);
    m_Tube.ends.first = Renumbered(m_Tube.ends.first, capped.keptVertices);
    m_Tube.ends.second = Renumbered(m_Tube.ends.second, capped.keptVertices);
    const auto kept = static_cast<Eigen::Index>(capped.keptVertices.size());
    this->WallPoints().values.bottomRows(m_Tube.surface.NumberOfVertices() - kept).setConstant(-1.0);
    this->Connect();
  }

  /** Adds `wallPointId` to the surface before its first change. */
  void
  NumberWallPoints()
  {
    auto & arrays = m_Tube.surface.pointArrays;
    if (!FindSurfaceArray(arrays, wallPointName))
    {
      const int number = m_Tube.surface.NumberOfVertices();
      arrays.push_back({ wallPointName, Eigen::VectorXd::LinSpaced(number, 0.0, number - 1.0), true });
    }
  }

  SurfaceArray &
  WallPoints()
  {
    auto & arrays = m_Tube.surface.pointArrays;
    return *std::find_if(
      arrays.begin(), arrays.end(), [](const SurfaceArray & array) { return array.name == wallPointName; });
  }

  const TubeMetric &                   m_Metric;
  const TubeOptions &                  m_Options;
  OpenEndedProgress                    m_Steps;      ///< each as long as a metric or a map, or less
  const int                            m_MostSolves; ///< per round
  UnfoldedTube                         m_Tube;
  std::unique_ptr<SurfaceConnectivity> m_Connectivity;
  bool                                 m_IsTube{ true }; ///< no handles
  FaceMarks                            m_IsFlipped;
  FaceMarks                            m_IsPouch;
  TubeMap                              m_Best; ///< of this surface, with the fewest avoidable flips
  std::ptrdiff_t                       m_FewestFlips{ 0 };
};
} // namespace

UnfoldedTube
FlattenWithoutFolds(SurfaceMesh mesh, const TubeEnds & ends, const TubeMetric & metric, const TubeOptions & options)
{
  return TubeUnfolding(std::move(mesh), ends, metric, options).Run();
}
} // namespace shapeton
