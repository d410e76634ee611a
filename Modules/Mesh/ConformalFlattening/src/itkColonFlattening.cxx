#include "itkColonFlattening.h"

#include "itkHeatDiffusionMetric.h"
#include "itkToolError.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace itk
{
namespace
{
constexpr double endOfCentreline = 20.0; // mm; there the radius is that of the end
constexpr int    ringsOfHandle = 3;

/** The chain of one surface; m_Result fills up on the way. */
class ColonFlattener
{
public:
  ColonFlattener(const std::string & what, const ColonFlatteningOptions & options) : m_What(what), m_Options(options) {}

  ColonFlattening
  Run(SurfaceMesh mesh)
  {
    this->Prepare(std::move(mesh));
    this->Flatten();
    m_Result.handles = DetectHandles(*m_Connectivity, m_Result.map.flat);
    this->CompareGenus();
    if (m_Options.removeHandles && !m_Result.handles.handles.empty())
    {
      this->Remove();
    }
    this->Measure();
    return std::move(m_Result);
  }

private:
  void
  Tell(const std::string & stage, double share) const
  {
    if (m_Options.progress)
    {
      m_Options.progress(stage, share);
    }
  }

  void
  Prepare(SurfaceMesh mesh)
  {
    this->Tell("Preparing", 0.0);
    PreparedTube tube = PrepareTube(std::move(mesh), m_What);
    m_Result.surface = std::move(tube.mesh);
    m_Result.warnings = std::move(tube.warnings);
    m_Result.metric = m_Options.metric;
    this->Connect();
    m_Result.genusBefore = m_Result.genusAfter = m_Connectivity->Components().front().genus.value_or(0);
    if (!m_Laplacian.clampedFaces.empty())
    {
      m_Result.warnings.push_back(m_What + ": " + std::to_string(m_Laplacian.clampedFaces.size()) +
                                  " faces with hardly any area, such as face " +
                                  std::to_string(m_Laplacian.clampedFaces.front()) + ", were taken for thin ones");
    }
    if (m_Result.rectumFrom == "firstLoop")
    {
      m_Result.warnings.push_back(m_What + " does not say which end is the rectum (field array rectumLoop, or " +
                                  "--centreline): u begins at the loop with the least vertex");
    }
  }

  /** All that depends on the faces, after each change of them. */
  void
  Connect()
  {
    m_Connectivity = std::make_unique<SurfaceConnectivity>(m_Result.surface);
    m_Ends = FindTubeEnds(m_Result.surface, *m_Connectivity, m_What);
    m_Result.rectumFrom = m_Ends.isRectumKnown ? "rectumLoop" : "firstLoop";
    const CurveSet & centreline = m_Options.centreline;
    if (!m_Ends.isRectumKnown && !centreline.curves.empty())
    {
      const Eigen::RowVector3d start = centreline.V.row(centreline.curves.front().front());
      if (this->DistanceOfLoop(m_Ends.second, start) < this->DistanceOfLoop(m_Ends.first, start))
      {
        std::swap(m_Ends.first, m_Ends.second);
      }
      m_Result.rectumFrom = "centreline";
    }
    m_Lengths = EdgeLengths(*m_Connectivity, m_Result.surface.V);
    m_Laplacian = MakeSurfaceLaplacian(*m_Connectivity, m_Lengths);
  }

  double
  DistanceOfLoop(const std::vector<int> & loop, const Eigen::RowVector3d & point) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const int v : loop)
    {
      least = std::min(least, (m_Result.surface.V.row(v) - point).norm());
    }
    return least;
  }

  /** The time given, or the default one, which needs to know how narrow the lumen is. */
  void
  ChooseTime()
  {
    if (m_Result.time > 0.0 || m_Options.time > 0.0)
    {
      m_Result.time = std::max(m_Result.time, m_Options.time);
      return;
    }
    const bool hasLine = !m_Options.centreline.curves.empty();
    m_Result.narrowestRadiusFrom = hasLine ? "centreline" : "surface";
    m_Result.narrowestRadius = hasLine ? NarrowestRadiusOfCentreline(m_Options.centreline)
                                       : NarrowestLevelRadius(m_Result.surface, HarmonicAlongTube(m_Laplacian, m_Ends));
    m_Result.time = DefaultDiffusionTime(*m_Connectivity, m_Lengths, m_Result.narrowestRadius);
  }

  /** The lengths of the edges in the metric of the map. */
  Eigen::VectorXd
  MetricLengths()
  {
    if (m_Options.metric == FlatMetric::Euclidean)
    {
      return m_Lengths;
    }
    this->ChooseTime();
    if (m_Options.metric == FlatMetric::HeatDiffusion)
    {
      return HeatDiffusionMetricSolver(m_Laplacian).Compute(m_Result.time).edgeLengths;
    }
    m_Result.eigenpairs = m_Options.eigenpairs;
    const SurfaceSpectrum spectrum = ComputeSurfaceSpectrum(m_Laplacian, m_Options.eigenpairs);
    return TruncatedHeatDiffusionMetric(m_Laplacian, spectrum, m_Result.time, m_Options.eigenpairs).edgeLengths;
  }

  void
  Flatten()
  {
    this->Tell(m_IsAgain ? "Metric without handles" : "Metric", m_IsAgain ? 0.55 : 0.05);
    m_Metric = this->MetricLengths();
    this->Tell(m_IsAgain ? "Flattening without handles" : "Flattening", m_IsAgain ? 0.8 : 0.4);
    m_Result.map = FlattenTube(m_Result.surface, *m_Connectivity, m_Metric, m_Ends, m_Options.tube);
    this->Tell(m_IsAgain ? "Distortion" : "Handles", m_IsAgain ? 0.9 : 0.5);
  }

  void
  CompareGenus()
  {
    if (m_Result.handles.genus != m_Result.genusBefore)
    {
      m_Result.warnings.push_back(m_What + " has " + std::to_string(m_Result.genusBefore) + " handles, but " +
                                  std::to_string(m_Result.handles.genus) + " were located: " +
                                  (m_Options.tube.conjugate == TubeConjugate::Published
                                     ? "the published method folds the map elsewhere, too"
                                     : "others lie at a boundary, or the map is folded in many places"));
    }
  }

  void
  Remove()
  {
    HandleRemoval removal = RemoveHandles(m_Result.surface, *m_Connectivity, m_Result.handles.handles);
    m_Result.surface = std::move(removal.mesh);
    m_Result.genusAfter = removal.genus;
    m_IsAgain = true;
    this->Connect();
    if (removal.genus > 0)
    {
      m_Result.warnings.push_back(m_What + ": " + std::to_string(removal.genus) + " handles could not be removed");
    }
    this->Flatten();
  }

  void
  Measure()
  {
    const SurfaceMesh &    flat = m_Result.map.flat;
    const Eigen::MatrixX2d uv = FlatCoordinates(flat, m_What);
    const SideLengths      sides = SidesOfFaces(*m_Connectivity, m_Metric);
    const SideLengths      sidesInSpace = SidesOfFaces(*m_Connectivity, m_Lengths);
    m_Result.distortion = MeasureFlatDistortion(flat.F, uv, sides);
    m_Result.distortionInSpace = MeasureFlatDistortion(flat.F, uv, sidesInSpace);
    m_Result.quality = MeasureTriangleQuality(sides);
    m_Result.qualityInSpace = MeasureTriangleQuality(sidesInSpace);
    const std::vector<SurfaceHandle> none;
    const std::vector<char>          isNear =
      FacesNearHandles(*m_Connectivity, m_IsAgain ? none : m_Result.handles.handles, ringsOfHandle);
    for (std::size_t f = 0; f < isNear.size(); ++f)
    {
      m_Result.flipsAwayFromHandles += m_Result.distortion.isFlipped[f] && !isNear[f] ? 1 : 0;
    }
  }

  const std::string &                  m_What;
  const ColonFlatteningOptions &       m_Options;
  std::unique_ptr<SurfaceConnectivity> m_Connectivity;
  TubeEnds                             m_Ends;
  Eigen::VectorXd                      m_Lengths; ///< in space
  Eigen::VectorXd                      m_Metric;
  SurfaceLaplacian                     m_Laplacian; ///< in space
  bool                                 m_IsAgain{ false };
  ColonFlattening                      m_Result;
};
} // namespace

ColonFlattening
FlattenColon(SurfaceMesh mesh, const std::string & what, const ColonFlatteningOptions & options)
{
  return ColonFlattener(what, options).Run(std::move(mesh));
}

double
NarrowestRadiusOfCentreline(const CurveSet & centreline)
{
  RequireSound(centreline, "the centreline");
  const Eigen::VectorXd      radii = PointValues(centreline, "radius", "the centreline");
  const SurfaceArray * const gap = FindSurfaceArray(centreline.pointArrays, "gap");
  const std::vector<int> &   curve = centreline.curves.front();
  std::vector<double>        arc{ 0.0 };
  for (std::size_t i = 1; i < curve.size(); ++i)
  {
    arc.push_back(arc.back() + (centreline.V.row(curve[i]) - centreline.V.row(curve[i - 1])).norm());
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < curve.size(); ++i)
  {
    const bool isEnd = arc[i] < endOfCentreline || arc.back() - arc[i] < endOfCentreline;
    const bool isGap = gap && gap->values(curve[i], 0) != 0.0;
    least = isEnd || isGap ? least : std::min(least, radii[curve[i]]);
  }
  if (!std::isfinite(least) || least <= 0.0)
  {
    throw InputError("the centreline has no point with a positive radius outside its gaps and 20 mm from its ends");
  }
  return least;
}
} // namespace itk
