#include "shapetonSurfaceRicciFlow.h"

#include "shapetonBoundaryLoops.h"
#include "shapetonCurvatureNewton.h"
#include "shapetonCutGraph.h"
#include "shapetonDevelopment.h"
#include "shapetonExceptions.h"
#include "shapetonNumberText.h"
#include "shapetonPi.h"
#include "shapetonRicciTargets.h"
#include "shapetonSphereFlow.h"
#include "shapetonSurfaceLaplacian.h"
#include "shapetonTrianglesOfGeometry.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace shapeton
{
namespace
{
constexpr double curvatureTolerance = RicciTolerance{}.accepted; // radians
/** Approximate fraction of the run time completed after the flow. */
constexpr double shareOfFlow = 0.9;
/** Curvatures below this value count as flat (radians). */
constexpr double flatCurvature = 1e-9;

double
AreaOfTriangle(RicciGeometry geometry, const std::array<double, 3> & sides)
{
  const TriangleAngles angles = AnglesOfTriangle(geometry, sides);
  if (geometry == RicciGeometry::Euclidean)
  {
    return 0.5 * sides[0] * sides[2] * angles.Sine(0);
  }
  const double excess = angles.Angle(0) + angles.Angle(1) + angles.Angle(2) - Pi;
  return geometry == RicciGeometry::Spherical ? excess : -excess;
}

double
AreaOf(RicciGeometry geometry, const SideLengths & sides)
{
  double area = 0.0;
  for (Eigen::Index f = 0; f < sides.rows(); ++f)
  {
    area += AreaOfTriangle(geometry, { sides(f, 0), sides(f, 1), sides(f, 2) });
  }
  return area;
}

/** Places of a flat layout on the cut surface, and their spread at each vertex. */
Eigen::MatrixX2d
PlacesOfVertices(const CutSurface & cut, const std::vector<PlanePoint> & places, double & spread)
{
  Eigen::MatrixX2d  uv = Eigen::MatrixX2d::Zero(cut.mesh.V.rows(), 2);
  std::vector<char> isSet(uv.rows(), 0);
  spread = 0.0;
  for (std::size_t side = 0; side < places.size(); ++side)
  {
    const int                v = cut.mesh.F(static_cast<Eigen::Index>(side / 3), static_cast<Eigen::Index>(side % 3));
    const Eigen::RowVector2d place(places[side].real(), places[side].imag());
    if (isSet[v])
    {
      spread = std::max(spread, (uv.row(v) - place).norm());
    }
    else
    {
      uv.row(v) = place;
      isSet[v] = 1;
    }
  }
  return uv;
}

/** Gauss reduction of a lattice basis; the result is positively oriented. */
std::array<PlanePoint, 2>
ReducedLattice(PlanePoint a, PlanePoint b)
{
  for (;;)
  {
    if (std::abs(b) < std::abs(a))
    {
      std::swap(a, b);
    }
    const double multiple = std::round((b / a).real());
    if (multiple == 0.0)
    {
      break;
    }
    b -= multiple * a;
  }
  return { a, (b / a).imag() > 0.0 ? b : -b };
}

/** One flow with its intermediate results. */
class Flow
{
public:
  Flow(const SurfaceMesh & mesh, const SurfaceRicciFlowSettings & options, const std::string & what)
    : m_Mesh(mesh), m_Options(options), m_What(what), m_Connectivity(mesh)
  {
    this->CheckSurface();
    m_Result.scheme = options.scheme;
    m_Result.genus = m_Topology.genus;
    m_Result.boundaries = m_Topology.boundaries;
    m_Result.geometry = ChooseGeometry(options, m_Topology, what);
    m_Result.targetCurvatures = FindTargets(options, m_Result.geometry, m_Topology, m_Connectivity, m_Lengths);
  }

  SurfaceRicciFlow
  Run()
  {
    if (m_Result.geometry == RicciGeometry::Spherical)
    {
      this->RunOnSphere();
    }
    else
    {
      this->RunInPlane();
    }
    this->CheckCurvatures();
    return std::move(m_Result);
  }

private:
  void
  CheckSurface()
  {
    RequireSound(m_Mesh, m_What);
    RequireOneManifold(m_Connectivity, m_What);
    if (!m_Connectivity.IsOriented())
    {
      throw InputError(m_What + ": its faces are not oriented consistently; repair it with SurfaceInspector");
    }
    const SurfaceComponent & component = m_Connectivity.Components().front();
    m_Topology.characteristic = component.eulerCharacteristic;
    m_Topology.genus = component.genus.value_or(0);
    m_Topology.boundaries = component.boundaryLoops;
    m_Topology.isTube = m_Topology.genus == 0 && m_Topology.boundaries == 2;
    m_IsBoundary.assign(m_Connectivity.NumberOfVertices(), 0);
    for (const auto & loop : m_Connectivity.BoundaryLoops())
    {
      for (const int v : loop)
      {
        m_IsBoundary[v] = 1;
      }
    }
    if (m_Topology.boundaries > 0)
    {
      BoundaryLoopsByLength(m_Connectivity, m_Mesh.V); // checks that boundaries do not touch
    }
    m_Lengths = m_Options.edgeLengths.size() > 0 ? m_Options.edgeLengths : EdgeLengths(m_Connectivity, m_Mesh.V);
    MakeSurfaceLaplacian(m_Connectivity, m_Lengths); // checks the lengths
    m_Area = AreaOf(RicciGeometry::Euclidean, SidesOfFaces(m_Connectivity, m_Lengths));
  }

  /** Scale of the lengths at the start of the flow. */
  double
  InitialScale() const
  {
    if (m_Result.geometry != RicciGeometry::Hyperbolic)
    {
      return 1.0;
    }
    const double area = m_Result.targetCurvatures.sum() - TwoPi * m_Topology.characteristic;
    return std::sqrt(area / m_Area);
  }

  RicciUnknowns
  Unknowns(const IntrinsicTriangulation & triangulation, bool isDouble) const
  {
    RicciUnknowns unknowns;
    const int     vertices = m_Connectivity.NumberOfVertices();
    unknowns.copies = isDouble ? 2 : 1;
    unknowns.isFixed.assign(vertices, 0);
    unknowns.gauge = m_Result.geometry == RicciGeometry::Euclidean ? vertices - 1 : -1;
    unknowns.angles = -m_Result.targetCurvatures;
    for (int v = 0; v < vertices; ++v)
    {
      unknowns.angles[v] += m_IsBoundary[v] ? Pi : TwoPi;
      unknowns.ofVertices.push_back(v);
    }
    for (int v = 0; v < vertices && static_cast<int>(unknowns.ofVertices.size()) < triangulation.NumberOfVertices();
         ++v)
    {
      if (!m_IsBoundary[v])
      {
        unknowns.ofVertices.push_back(v);
      }
    }
    return unknowns;
  }

  void
  RunInPlane()
  {
    const bool             isScaling = m_Options.scheme == RicciScheme::VertexScaling;
    const bool             isDouble = isScaling && m_Topology.boundaries > 0;
    IntrinsicTriangulation triangulation = isDouble ? IntrinsicTriangulation::Double(m_Mesh.F, m_Connectivity)
                                                    : IntrinsicTriangulation(m_Mesh.F, m_Connectivity);
    const RicciUnknowns    unknowns = this->Unknowns(triangulation, isDouble);
    Eigen::VectorXd        invariants = this->LengthsOf(triangulation) * this->InitialScale();
    Eigen::VectorXd        start = Eigen::VectorXd::Zero(m_Connectivity.NumberOfVertices());
    if (!isScaling)
    {
      const InversivePacking packing = MakeInversivePacking(triangulation, invariants, m_Result.geometry);
      start = packing.u;
      invariants = packing.distances;
      this->CheckDistances(invariants);
    }
    ConformalMetric metric(std::move(triangulation), invariants, m_Options.scheme, m_Result.geometry);
    m_Result.delaunayFlips = isScaling ? metric.MakeDelaunay() : 0;
    m_Solution = SolveForCurvature(
      metric, unknowns, start, RicciTolerance{}, m_Options.progress.Part("Ricci flow", 0.0, shareOfFlow));
    this->NormalizeArea(metric, unknowns);
    m_Result.steps = m_Solution.steps;
    m_Result.flips = static_cast<int>(metric.Flips().size()) - m_Result.delaunayFlips;
    m_Result.logScales = m_Solution.u - start;
    this->MeasureCurvatures(metric, unknowns);
    this->DevelopSurface(metric, isDouble);
  }

  /** Lengths of the edges of the triangulation, which is not flipped yet. */
  Eigen::VectorXd
  LengthsOf(const IntrinsicTriangulation & triangulation) const
  {
    Eigen::VectorXd lengths(triangulation.NumberOfEdges());
    const int       sides = static_cast<int>(m_Mesh.F.size());
    for (int side = 0; side < triangulation.NumberOfSides(); ++side)
    {
      const int face = side / 3, k = side % 3;
      lengths[triangulation.EdgeOf(side)] =
        m_Lengths[side < sides ? m_Connectivity.EdgeOfFace(face, k)
                               : m_Connectivity.EdgeOfFace(face - m_Connectivity.NumberOfFaces(), 2 - k)];
    }
    return lengths;
  }

  void
  CheckDistances(const Eigen::VectorXd & distances)
  {
    const auto negative = (distances.array() < 0.0).count();
    if (negative > 0)
    {
      m_Result.warnings.push_back(std::to_string(negative) +
                                  " inversive distances are negative, so that uniqueness is not proven");
    }
  }

  void
  NormalizeArea(ConformalMetric & metric, const RicciUnknowns & unknowns)
  {
    if (m_Result.geometry != RicciGeometry::Euclidean)
    {
      return;
    }
    const double area =
      AreaOf(m_Result.geometry, FacesOf(metric.Triangulation(), metric.Lengths()).sides) / unknowns.copies;
    m_Solution.u.array() += 0.5 * std::log(m_Area / area);
    metric.ScaleLengths(std::sqrt(m_Area / area));
  }

  void
  MeasureCurvatures(const ConformalMetric & metric, const RicciUnknowns & unknowns)
  {
    const Eigen::VectorXd sums = metric.AngleSums();
    m_Result.curvatures = m_Result.targetCurvatures + unknowns.angles;
    for (Eigen::Index v = 0; v < sums.size(); ++v)
    {
      m_Result.curvatures[unknowns.ofVertices[v]] -= sums[v] / unknowns.copies;
    }
  }

  std::vector<int>
  Cones() const
  {
    std::vector<int> cones;
    for (int v = 0; v < m_Connectivity.NumberOfVertices(); ++v)
    {
      if (!m_IsBoundary[v] && std::abs(m_Result.targetCurvatures[v]) > flatCurvature)
      {
        cones.push_back(v);
      }
    }
    return cones;
  }

  void
  DevelopSurface(const ConformalMetric & metric, bool isDouble)
  {
    IntrinsicTriangulation        triangulation = metric.Triangulation();
    const RicciGeometry           geometry = m_Result.geometry;
    const std::vector<PlanePoint> finalCharts = ChartsOfFaces(triangulation, metric.Lengths(), geometry);
    std::vector<PlanePoint>       charts = finalCharts;
    UndoFlips(metric.Flips(), geometry, triangulation, charts);
    if (isDouble) // what remains is the surface itself
    {
      triangulation = IntrinsicTriangulation(m_Mesh.F, m_Connectivity);
      charts.resize(m_Mesh.F.size());
    }
    m_Result.edgeLengths.resize(m_Connectivity.NumberOfEdges());
    for (int e = 0; e < m_Connectivity.NumberOfEdges(); ++e)
    {
      const int side = triangulation.SideOf(e);
      m_Result.edgeLengths[e] = DistanceInPlane(geometry, charts[side], charts[IntrinsicTriangulation::Next(side)]);
    }
    const GeodesicFaces faces = isDouble ? this->HalfFaces(metric.Triangulation(), finalCharts)
                                         : FacesOf(metric.Triangulation(), metric.Lengths());
    m_Result.triangles = faces.F;
    m_Result.sides = faces.sides;
    m_Result.area = AreaOf(geometry, faces.sides);
    this->LayOut(triangulation, charts);
  }

  GeodesicFaces
  HalfFaces(const IntrinsicTriangulation & triangulation, const std::vector<PlanePoint> & charts) const
  {
    std::vector<char> sideOfVertices(triangulation.NumberOfVertices(), 2);
    for (int v = 0; v < m_Connectivity.NumberOfVertices(); ++v)
    {
      sideOfVertices[v] = m_IsBoundary[v] ? 0 : 1;
    }
    std::vector<std::pair<std::array<int, 2>, double>> axis;
    for (int e = 0; e < m_Connectivity.NumberOfEdges(); ++e)
    {
      if (m_Connectivity.IsBoundaryEdge(e))
      {
        axis.emplace_back(m_Connectivity.VerticesOfEdge(e), m_Result.edgeLengths[e]);
      }
    }
    return HalfOfDouble(triangulation, charts, sideOfVertices, axis, m_Result.geometry);
  }

  void
  LayOut(const IntrinsicTriangulation & triangulation, const std::vector<PlanePoint> & charts)
  {
    const CutGraph                graph = FindCutGraph(m_Connectivity, m_Result.edgeLengths, this->Cones());
    std::vector<std::vector<int>> paths;
    for (int e = 0; e < m_Connectivity.NumberOfEdges(); ++e)
    {
      if (graph.isCut[e])
      {
        const auto & ends = m_Connectivity.VerticesOfEdge(e);
        paths.push_back({ ends[0], ends[1] });
      }
    }
    std::vector<PlanePoint> places =
      LayOutFaces(triangulation, charts, graph.isCut, m_Result.geometry, InnermostFace(triangulation, graph.isCut));
    this->FindPeriods(triangulation, graph, places);
    CutSurface             cut = CutAlongPaths(m_Mesh, m_Connectivity, paths);
    const Eigen::MatrixX2d uv = PlacesOfVertices(cut, places, m_Result.layoutResidual);
    if (!uv.allFinite())
    {
      throw InputError(m_What + ": the result of the Ricci flow is too degenerate to be laid out in double precision; "
                                "choose cones near the handles, or hyperbolic geometry");
    }
    this->CountFlippedFaces(places);
    m_Result.flat = MakeFlatSurface(std::move(cut), uv);
    if (m_Result.modulus > 0.0)
    {
      SetFlatExtent(m_Result.flat, m_Circumference, m_Result.area / m_Circumference);
    }
  }

  void
  CountFlippedFaces(const std::vector<PlanePoint> & places)
  {
    for (std::size_t side = 0; side < places.size(); side += 3)
    {
      m_Result.flippedFaces +=
        IsCounterclockwise(m_Result.geometry, places[side], places[side + 1], places[side + 2]) ? 0 : 1;
    }
    if (m_Result.flippedFaces > 0)
    {
      m_Result.warnings.push_back(std::to_string(m_Result.flippedFaces) +
                                  " faces of the surface are inverted in the plane, because their edges were flipped; "
                                  "the final triangulation has no inverted faces");
    }
  }

  /** Translation from one side of a cut edge to the other. */
  static PlanePoint
  PeriodOf(const IntrinsicTriangulation & triangulation, const std::vector<PlanePoint> & places, int edge)
  {
    const int side = triangulation.SideOf(edge);
    return places[IntrinsicTriangulation::Next(triangulation.Twin(side))] - places[side];
  }

  /** Periods of a flat torus, and the position of a flat tube. */
  void
  FindPeriods(const IntrinsicTriangulation & triangulation, const CutGraph & graph, std::vector<PlanePoint> & places)
  {
    const bool isFlat =
      m_Result.geometry == RicciGeometry::Euclidean && m_Result.targetCurvatures.cwiseAbs().maxCoeff() < flatCurvature;
    if (isFlat && m_Topology.boundaries == 0)
    {
      const auto [a, b] = ReducedLattice(PeriodOf(triangulation, places, graph.generators[0]),
                                         PeriodOf(triangulation, places, graph.generators[1]));
      m_Result.periods = { { std::abs(a), 0.0 },
                           { (b * std::conj(a)).real() / std::abs(a), (b * std::conj(a)).imag() / std::abs(a) } };
      m_Result.tau = b / a;
      Turn(places, std::conj(a) / std::abs(a), 0.0);
    }
    if (isFlat && m_Topology.isTube)
    {
      const int edge = static_cast<int>(std::find(graph.isCut.begin(), graph.isCut.end(), 1) - graph.isCut.begin());
      const PlanePoint period = PeriodOf(triangulation, places, edge);
      m_Circumference = std::abs(period);
      m_Result.modulus = m_Circumference * m_Circumference / m_Result.area;
      Turn(places, PlanePoint(0.0, 1.0) * std::conj(period) / m_Circumference, 0.0);
      this->StartAtFirstBoundary(triangulation, places);
    }
  }

  /** Turns and moves the layout of a tube so that u is 0 at the first boundary and positive elsewhere, v >= 0. */
  void
  StartAtFirstBoundary(const IntrinsicTriangulation & triangulation, std::vector<PlanePoint> & places) const
  {
    const int first = m_Connectivity.BoundaryLoops().front().front();
    double    atFirst = 0.0, sum = 0.0;
    for (int side = 0; side < triangulation.NumberOfSides(); ++side)
    {
      sum += places[side].real();
      if (triangulation.Origin(side) == first)
      {
        atFirst = places[side].real();
      }
    }
    const double sign = sum / static_cast<double>(places.size()) > atFirst ? 1.0 : -1.0;
    double       lowest = 0.0;
    for (const PlanePoint & place : places)
    {
      lowest = std::min(lowest, sign * place.imag());
    }
    Turn(places, sign, PlanePoint(-sign * atFirst, -lowest));
  }

  static void
  Turn(std::vector<PlanePoint> & places, PlanePoint factor, PlanePoint shift)
  {
    for (PlanePoint & place : places)
    {
      place = factor * place + shift;
    }
  }

  void
  RunOnSphere()
  {
    IntrinsicTriangulation triangulation(m_Mesh.F, m_Connectivity);
    ConformalMetric        start(triangulation, m_Lengths, RicciScheme::VertexScaling, RicciGeometry::Euclidean);
    m_Result.delaunayFlips = start.MakeDelaunay();
    triangulation = start.Triangulation();
    const Eigen::VectorXd weights = MakeSurfaceLaplacian(m_Connectivity, m_Lengths).mass;
    const auto            sphere =
      FlowToSphere(triangulation, start.Invariants(), weights, m_Options.progress.Part("Ricci flow", 0.0, shareOfFlow));
    m_Result.steps = sphere.steps;
    m_Result.flips = sphere.flips;
    m_Result.logScales = sphere.logScales;
    const Eigen::VectorXd lengths =
      sphere.chords.unaryExpr([](double chord) { return 2.0 * std::asin(std::min(1.0, 0.5 * chord)); });
    const GeodesicFaces faces = FacesOf(triangulation, lengths);
    m_Result.triangles = faces.F;
    m_Result.sides = faces.sides;
    m_Result.area = AreaOf(RicciGeometry::Spherical, faces.sides);
    this->MeasureSphere(sphere.places);
  }

  void
  MeasureSphere(const VertexMatrix & places)
  {
    m_Result.curvatures = Eigen::VectorXd::Constant(m_Connectivity.NumberOfVertices(), TwoPi);
    for (Eigen::Index f = 0; f < m_Result.triangles.rows(); ++f)
    {
      const TriangleAngles angles = AnglesOfTriangle(
        RicciGeometry::Spherical, { m_Result.sides(f, 0), m_Result.sides(f, 1), m_Result.sides(f, 2) });
      for (int k = 0; k < 3; ++k)
      {
        m_Result.curvatures[m_Result.triangles(f, k)] -= angles.Angle(k);
      }
    }
    m_Result.edgeLengths.resize(m_Connectivity.NumberOfEdges());
    for (int e = 0; e < m_Connectivity.NumberOfEdges(); ++e)
    {
      const auto & ends = m_Connectivity.VerticesOfEdge(e);
      m_Result.edgeLengths[e] = 2.0 * std::asin(0.5 * (places.row(ends[0]) - places.row(ends[1])).norm());
    }
    for (int f = 0; f < m_Mesh.NumberOfFaces(); ++f)
    {
      const Eigen::RowVector3d a = places.row(m_Mesh.F(f, 0)), b = places.row(m_Mesh.F(f, 1)),
                               c = places.row(m_Mesh.F(f, 2));
      m_Result.flippedFaces += a.cross(b).dot(c) > 0.0 ? 0 : 1;
    }
    m_Result.flat = m_Mesh;
    SurfaceArray source{ "sourcePointId", {}, true };
    source.values =
      Eigen::VectorXd::LinSpaced(places.rows(), 0.0, static_cast<double>(places.rows() - 1)).array().round();
    m_Result.flat.pointArrays.push_back({ "sphere", places, false });
    m_Result.flat.pointArrays.push_back(std::move(source));
  }

  void
  CheckCurvatures()
  {
    m_Result.residual = (m_Result.curvatures - m_Result.targetCurvatures).cwiseAbs().maxCoeff();
    if (!(m_Result.residual <= curvatureTolerance))
    {
      const std::string text =
        m_What + ": the Ricci flow ends with a curvature error of " + NumberText(m_Result.residual) + " rad";
      constexpr double unusable = 1e-6;
      if (!(m_Result.residual <= unusable))
      {
        throw InputError(text);
      }
      m_Result.warnings.push_back(text);
    }
  }

  const SurfaceMesh &              m_Mesh;
  const SurfaceRicciFlowSettings & m_Options;
  std::string                      m_What;
  SurfaceConnectivity              m_Connectivity;
  RicciTopology                    m_Topology;
  std::vector<char>                m_IsBoundary; ///< for each vertex
  Eigen::VectorXd                  m_Lengths;
  double                           m_Area{ 0.0 };
  double                           m_Circumference{ 0.0 };
  RicciSolution                    m_Solution;
  SurfaceRicciFlow                 m_Result;
};
} // namespace

SurfaceRicciFlow
FlowSurface(const SurfaceMesh & mesh, const SurfaceRicciFlowSettings & options, const std::string & what)
{
  return Flow(mesh, options, what).Run();
}

SurfaceMesh
FinalTriangulation(const SurfaceMesh & mesh, const SurfaceRicciFlow & flow)
{
  SurfaceMesh result = mesh;
  result.F = flow.triangles;
  result.cellArrays.clear();
  result.cellArrays.push_back({ "sides", flow.sides, false });
  return result;
}
} // namespace shapeton
