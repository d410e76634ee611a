#include "shapetonColonFlattening.h"

#include "shapetonHandleLoops.h"
#include "shapetonHeatDiffusionMetric.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <sstream>

namespace shapeton
{
namespace
{
/** Name of the surface in warnings. It must not be a path, because result files contain the warnings. */
constexpr const char * surfaceName = "the surface";
constexpr int          ringsOfHandle = 3;
constexpr int          mostRounds = 5;     // maximum number of removal rounds
constexpr double       largeHandle = 30.0; // mm; noise loops are smaller
constexpr double       foldedShare = 0.01; // fraction of the faces

/** The processing chain for one surface; fills m_Result step by step. */
class ColonFlattener
{
public:
  ColonFlattener(const std::string & what, const ColonFlatteningSettings & options) : m_What(what), m_Options(options)
  {}

  ColonFlattening
  Run(SurfaceMesh mesh)
  {
    this->Prepare(std::move(mesh));
    m_Options.progress("Handles", 0.05);
    this->RemoveHandlesIfAsked();
    this->Flatten();
    m_Options.progress("Distortion", 0.9);
    const HandleDetection left = DetectHandles(*m_Connectivity, m_Result.map.flat);
    if (m_Options.topology == SurfaceTopology::Raw)
    {
      m_Result.handles = left;
    }
    else
    {
      this->PlaceOnMap();
    }
    this->CompareGenus();
    this->Measure(left.handles);
    m_Options.progress("Distortion", 1.0);
    return std::move(m_Result);
  }

private:
  void
  Prepare(SurfaceMesh mesh)
  {
    m_Options.progress("Preparing", 0.0);
    PreparedTube tube = PrepareTube(std::move(mesh), m_What);
    m_Options.progress("Preparing", 0.02);
    m_Result.surface = std::move(tube.mesh);
    m_Result.warnings = std::move(tube.warnings);
    m_Result.metric = m_Options.metric;
    this->Connect();
    m_Options.progress("Preparing", 0.04);
    this->Trim();
    m_Result.genusBefore = m_Result.genusAfter = m_Connectivity->Components().front().genus.value_or(0);
    if (!m_Laplacian.clampedFaces.empty())
    {
      m_Result.warnings.push_back(std::string(surfaceName) + ": " + std::to_string(m_Laplacian.clampedFaces.size()) +
                                  " nearly degenerate faces, such as face " +
                                  std::to_string(m_Laplacian.clampedFaces.front()) + ", were treated as thin faces");
    }
    if (m_Result.rectumFrom == "firstLoop")
    {
      m_Result.warnings.push_back(std::string(surfaceName) +
                                  " does not identify the rectum end (field array rectumLoop, or " +
                                  "the parameter \"centerline\"): u starts at the loop with the lowest vertex index");
    }
  }

  void
  Trim()
  {
    m_AreaOfTube = SurfaceArea(m_Result.surface.V, m_Result.surface.F);
    TrimmedTube trimmed = TrimEars(std::move(m_Result.surface), *m_Connectivity);
    m_Result.surface = std::move(trimmed.mesh);
    if (trimmed.faces > 0)
    {
      this->Connect();
      m_Result.ears = trimmed.faces;
      m_Result.cutOffAreaFraction = trimmed.area / m_AreaOfTube;
      m_Result.warnings.push_back(std::string(surfaceName) + ": " + std::to_string(trimmed.faces) +
                                  " faces at its ends were removed because single edges cut them off");
    }
  }

  /** Updates everything that depends on the faces; called whenever they have changed. */
  void
  Connect()
  {
    m_Connectivity = std::make_unique<SurfaceConnectivity>(m_Result.surface);
    m_Ends = FindTubeEnds(m_Result.surface, *m_Connectivity, m_What);
    m_Result.rectumFrom = m_Ends.isRectumKnown ? "rectumLoop" : "firstLoop";
    const CurveSet & centerline = m_Options.centerline;
    if (!m_Ends.isRectumKnown && !centerline.curves.empty())
    {
      const Eigen::RowVector3d start = centerline.V.row(centerline.curves.front().front());
      const double             toFirst = this->DistanceOfLoop(m_Ends.first, start);
      const double             toSecond = this->DistanceOfLoop(m_Ends.second, start);
      const Eigen::RowVector3d ofFirst = m_Result.surface.V.row(m_Ends.first.front());
      if (std::min(toFirst, toSecond) > this->DistanceOfLoop(m_Ends.second, ofFirst))
      {
        throw InputError("the centerline begins farther from both ends of the surface than these are apart; use the "
                         "centerline of this surface, in LPS and mm");
      }
      if (toSecond < toFirst)
      {
        std::swap(m_Ends.first, m_Ends.second);
      }
      m_Result.rectumFrom = "centerline";
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

  /** Uses the given time, or the default time, which depends on the smallest radius; uses the Euclidean metric if no
   * time is suitable. */
  void
  ChooseTime()
  {
    const double edge = m_Lengths.mean();
    m_Result.time = m_Options.time;
    if (!(m_Result.time > 0.0))
    {
      const Eigen::VectorXd along =
        HarmonicAlongTube(m_Laplacian, m_Ends, m_Options.progress.Part("Time of diffusion", 0.15, 0.2));
      m_Result.narrowestRadius = NarrowestLevelRadius(m_Result.surface, along);
      if (IsTooCoarseForDiffusion(edge, m_Result.narrowestRadius))
      {
        this->TakeEuclideanMetric(edge);
        return;
      }
      m_Result.time = DefaultDiffusionTime(edge, m_Result.narrowestRadius);
    }
    if (m_Result.time < edge * edge)
    {
      m_Result.warnings.push_back(
        std::string(surfaceName) + ": the diffusion time is less than the square of the mean edge length, " +
        std::to_string(edge) +
        " mm, so the metric depends on the mesh; use a finer surface or the parameter \"metric\" = euclidean");
    }
  }

  void
  TakeEuclideanMetric(double edge)
  {
    m_Result.metric = FlatMetric::Euclidean;
    m_Result.warnings.push_back(std::string(surfaceName) + ": the mean edge length, " + std::to_string(edge) +
                                " mm, is too long for a diffusion time that preserves the narrowest part, of radius " +
                                std::to_string(m_Result.narrowestRadius) +
                                " mm: the metric is euclidean; use a finer surface");
  }

  /** Edge lengths of a surface in the metric of the map. */
  Eigen::VectorXd
  MetricLengths(const SurfaceMesh & surface, const SurfaceConnectivity & connectivity, const Progress & progress)
  {
    const Eigen::VectorXd lengths = EdgeLengths(connectivity, surface.V);
    if (m_Result.metric == FlatMetric::Euclidean)
    {
      return lengths;
    }
    const SurfaceLaplacian laplacian = MakeSurfaceLaplacian(connectivity, lengths);
    if (m_Result.metric == FlatMetric::HeatDiffusion)
    {
      HeatDiffusionMetric metric = ComputeHeatDiffusionMetric(connectivity, laplacian, m_Result.time, progress);
      m_Result.drownedEdges = metric.drownedEdges;
      return std::move(metric.edgeLengths);
    }
    m_Result.eigenpairs = m_Options.eigenpairs;
    SurfaceSpectrumOptions options;
    options.progress = progress;
    const SurfaceSpectrum spectrum = ComputeSurfaceSpectrum(laplacian, m_Options.eigenpairs, options);
    return TruncatedHeatDiffusionMetric(laplacian, spectrum, m_Result.time, m_Options.eigenpairs).edgeLengths;
  }

  void
  Flatten()
  {
    m_Options.progress("Time of diffusion", 0.15);
    if (m_Options.metric != FlatMetric::Euclidean)
    {
      this->ChooseTime();
    }
    const TubeMetric metric =
      [this](const SurfaceMesh & surface, const SurfaceConnectivity & connectivity, const Progress & progress) {
        return this->MetricLengths(surface, connectivity, progress);
      };
    TubeOptions options;
    options.conjugate = m_Options.method;
    options.cutCurve = m_Options.cut;
    options.progress = [this](const std::string & stage, double share) {
      m_Options.progress(stage, 0.2 + 0.7 * share);
    };
    UnfoldedTube tube = FlattenWithoutFolds(std::move(m_Result.surface), m_Ends, metric, options);
    m_Result.surface = std::move(tube.surface);
    m_Result.map = std::move(tube.map);
    m_Result.solves = tube.solves;
    m_Result.caps = std::move(tube.caps);
    m_Metric = std::move(tube.edgeLengths);
    if (!m_Result.caps.empty())
    {
      m_Connectivity = std::make_unique<SurfaceConnectivity>(m_Result.surface);
      m_Lengths = EdgeLengths(*m_Connectivity, m_Result.surface.V);
      m_Result.genusAfter = m_Connectivity->Components().front().genus.value_or(0);
      this->ReportCaps();
    }
  }

  void
  ReportCaps()
  {
    double area = 0.0;
    for (const PouchCap & cap : m_Result.caps)
    {
      area += cap.area / m_AreaOfTube;
    }
    m_Result.cutOffAreaFraction += area;
    std::ostringstream text;
    text << surfaceName << ": " << m_Result.caps.size() << " blind pouches with " << 100.0 * area
         << " % of the wall were cut off and closed by caps, because their flat map would be folded";
    m_Result.warnings.push_back(text.str());
  }

  void
  RemoveHandlesIfAsked()
  {
    if (m_Options.topology == SurfaceTopology::Raw || m_Result.genusBefore == 0)
    {
      return;
    }
    if (m_Options.topology == SurfaceTopology::Denoised)
    {
      this->CutAlongLoops();
    }
    else
    {
      this->RemoveInRounds();
    }
    if (m_Result.genusAfter > 0)
    {
      m_Result.warnings.push_back(std::string(surfaceName) + ": " + std::to_string(m_Result.genusAfter) +
                                  " handles could not be removed");
    }
  }

  void
  CutAlongLoops()
  {
    HandleCuts cuts = CutHandles(std::move(m_Result.surface));
    m_Result.surface = std::move(cuts.mesh);
    m_Result.genusAfter = cuts.genus;
    m_Result.handles.handles = std::move(cuts.handles);
    m_Result.handles.genus = static_cast<int>(m_Result.handles.handles.size());
    this->Connect();
  }

  void
  RemoveInRounds()
  {
    for (int round = 0; round < mostRounds && m_Result.genusAfter > 0; ++round)
    {
      TubeOptions options;
      options.progress =
        m_Options.progress.Part("Handles", 0.05 + 0.1 * round / mostRounds, 0.05 + 0.1 * (round + 1) / mostRounds);
      const TubeMap         map = FlattenTube(m_Result.surface, *m_Connectivity, m_Lengths, m_Ends, options);
      const HandleDetection found = DetectHandles(*m_Connectivity, map.flat);
      if (found.handles.empty())
      {
        break;
      }
      HandleRemoval removal = RemoveHandles(m_Result.surface, *m_Connectivity, found.handles);
      m_Result.surface = std::move(removal.mesh);
      m_Result.genusAfter = removal.genus;
      this->Connect();
      auto & all = m_Result.handles;
      all.handles.insert(all.handles.end(), found.handles.begin(), found.handles.end());
      all.falseAlarms += round == 0 ? found.falseAlarms : 0;
      all.genus += found.genus;
    }
  }

  /** Positions of the removed handles on the final map, at the nearest vertex. */
  void
  PlaceOnMap()
  {
    const SurfaceMesh &    flat = m_Result.map.flat;
    const Eigen::MatrixX2d uv = FlatCoordinates(flat, m_What);
    for (SurfaceHandle & handle : m_Result.handles.handles)
    {
      Eigen::Index nearest = 0;
      (flat.V.rowwise() - handle.place.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
      handle.flatPlace = uv.row(nearest).transpose();
    }
  }

  void
  CompareGenus()
  {
    for (const SurfaceHandle & handle : m_Result.handles.handles)
    {
      if (handle.radius > largeHandle)
      {
        std::ostringstream text;
        text << surfaceName << ": a handle of radius " << handle.radius << " mm at " << handle.place.transpose()
             << ": parts of the colon seem to touch there, and the wall between them is not mapped; use a surface "
             << "with repaired topology, such as wall-repaired.vtp of ColonSegmentation";
        m_Result.warnings.push_back(text.str());
      }
    }
    const int expected = m_Options.topology == SurfaceTopology::Raw ? m_Result.genusAfter : m_Result.genusBefore;
    if (m_Result.handles.genus != expected)
    {
      m_Result.warnings.push_back(std::string(surfaceName) + " has " + std::to_string(expected) + " handles, but " +
                                  std::to_string(m_Result.handles.genus) + " were located: " +
                                  (m_Options.method == TubeConjugate::Published
                                     ? "the published method also folds the map elsewhere"
                                     : "the others are at a boundary, or the map is folded in many places"));
    }
  }

  void
  Measure(const std::vector<SurfaceHandle> & left)
  {
    const SurfaceMesh &    flat = m_Result.map.flat;
    const Eigen::MatrixX2d uv = FlatCoordinates(flat, m_What);
    const SideLengths      sides = SidesOfFaces(*m_Connectivity, m_Metric);
    const SideLengths      sidesInSpace = SidesOfFaces(*m_Connectivity, m_Lengths);
    m_Result.distortion = MeasureFlatDistortion(flat.F, uv, sides);
    m_Result.distortionInSpace = MeasureFlatDistortion(flat.F, uv, sidesInSpace);
    m_Result.quality = MeasureTriangleQuality(sides);
    m_Result.qualityInSpace = MeasureTriangleQuality(sidesInSpace);
    const std::vector<char> isNear = FacesNearHandles(*m_Connectivity, left, ringsOfHandle);
    for (std::size_t f = 0; f < isNear.size(); ++f)
    {
      m_Result.flipsAwayFromHandles += m_Result.distortion.isFlipped[f] && !isNear[f] ? 1 : 0;
    }
    if (m_Result.distortion.flips > foldedShare * flat.NumberOfFaces())
    {
      m_Result.warnings.push_back(std::string(surfaceName) + ": " + std::to_string(m_Result.distortion.flips) + " of " +
                                  std::to_string(flat.NumberOfFaces()) +
                                  " faces are folded on the map; check the handles, or remesh the surface");
    }
  }

  const std::string &                  m_What;
  const ColonFlatteningSettings &      m_Options;
  std::unique_ptr<SurfaceConnectivity> m_Connectivity;
  TubeEnds                             m_Ends;
  Eigen::VectorXd                      m_Lengths; ///< in space
  Eigen::VectorXd                      m_Metric;
  SurfaceLaplacian                     m_Laplacian;         ///< in space
  double                               m_AreaOfTube{ 0.0 }; ///< mm^2
  ColonFlattening                      m_Result;
};
} // namespace

ColonFlattening
FlattenColon(SurfaceMesh mesh, const std::string & what, const ColonFlatteningSettings & options)
{
  CheckOptions(options);
  return ColonFlattener(what, options).Run(std::move(mesh));
}
} // namespace shapeton
