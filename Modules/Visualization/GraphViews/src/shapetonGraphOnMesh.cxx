#include "shapetonGraphOnMesh.h"

#include "shapetonCurveSet.h"
#include "shapetonExceptions.h"
#include "shapetonFlatSurface.h"
#include "shapetonModelSpace.h"
#include "shapetonPathsOfEdges.h"
#include "shapetonSpaceCells.h"
#include "shapetonSurfaceLocator.h"
#include "shapetonSurfaceRicciFlow.h"
#include "shapetonTorusInSpace.h"

#include <Eigen/Geometry>

#include <cmath>

namespace shapeton
{
namespace
{
using Complex = std::complex<double>;

/** A surface developed on the sphere or in the plane, and the inverse map. */
class DevelopedMesh
{
public:
  DevelopedMesh(const SurfaceMesh & flat, const VertexMatrix & places)
    : m_Flat(flat), m_Places(places), m_Locator(places, flat.F)
  {}

  SurfaceLocator::Closest
  Find(const Eigen::Vector3d & place) const
  {
    return m_Locator.FindClosest(place);
  }

  /** The face in which the ray from the origin through a point of the sphere meets the polyhedron. */
  SurfaceLocator::Closest
  FindOnRay(const Eigen::Vector3d & direction) const
  {
    constexpr int           mostSteps = 50;
    constexpr double        rounding = 1e-14;
    SurfaceLocator::Closest closest = m_Locator.FindClosest(direction);
    for (int i = 0; i < mostSteps && closest.distance > rounding; ++i)
    {
      closest = m_Locator.FindClosest(closest.point.dot(direction) * direction);
    }
    return closest;
  }

  /** The point in space for a point of the development. */
  Eigen::Vector3d
  InSpace(const SurfaceLocator::Closest & closest) const
  {
    const auto corner = [&](const VertexMatrix & V, int k) -> Eigen::Vector3d {
      return V.row(m_Flat.F(closest.face, k)).transpose();
    };
    const Eigen::Vector3d a = corner(m_Places, 0), u = corner(m_Places, 1) - a, v = corner(m_Places, 2) - a;
    const Eigen::Vector3d normal = u.cross(v), w = closest.point - a;
    const double          square = std::max(normal.squaredNorm(), 1e-300);
    const double          s = w.cross(v).dot(normal) / square, t = u.cross(w).dot(normal) / square;
    return (1.0 - s - t) * corner(m_Flat.V, 0) + s * corner(m_Flat.V, 1) + t * corner(m_Flat.V, 2);
  }

private:
  const SurfaceMesh & m_Flat;
  VertexMatrix        m_Places;
  SurfaceLocator      m_Locator;
};

double
MeanEdge(const VertexMatrix & V, const FaceMatrix & F)
{
  double sum = 0.0;
  for (Eigen::Index f = 0; f < F.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      sum += (V.row(F(f, k)) - V.row(F(f, (k + 1) % 3))).norm();
    }
  }
  return sum / static_cast<double>(F.size());
}

/** Number of pieces of a geodesic, each about half an edge of the surface. */
int
PiecesOf(double length, double edge)
{
  constexpr double mostPieces = 2000.0;
  return static_cast<int>(std::min(mostPieces, std::ceil(2.0 * length / edge) + 1.0));
}

void
MapSphere(const EmbeddingCertificate & certificate, const SurfaceRicciFlow & flow, GraphOnMesh & result)
{
  const VertexMatrix  sphere = FindSurfaceArray(flow.flat.pointArrays, "sphere")->values;
  const DevelopedMesh developed(flow.flat, sphere);
  const ModelSpace    space(EmbeddingGeometry::Spherical);
  const double        edge = MeanEdge(sphere, flow.flat.F);
  const auto          placeOf = [&](int node) {
    const double * const p = certificate.nodePositions.data() + 3 * static_cast<std::size_t>(node);
    return Place{ p[0], p[1], p[2] };
  };
  const auto toMesh = [&](const Place & place) {
    const auto closest = developed.FindOnRay(Eigen::Vector3d(place.x, place.y, place.z).normalized());
    result.gap = std::max(result.gap, closest.point.cross(Eigen::Vector3d(place.x, place.y, place.z)).norm());
    return developed.InSpace(closest);
  };
  for (int node = 0; node < certificate.graph.nodes; ++node)
  {
    result.nodes.push_back(toMesh(placeOf(node)));
  }
  for (const std::vector<int> & path : PathsOfEdges(certificate.graph.edges.size(), certificate.subdivided))
  {
    std::vector<Eigen::Vector3d> curve;
    for (const int h : path)
    {
      const auto & ends = certificate.packed.edges[h / 2];
      const int    from = ends[h % 2], to = ends[1 - h % 2];
      const int    pieces = PiecesOf(certificate.nodeRadii[from] + certificate.nodeRadii[to], edge);
      for (int i = curve.empty() ? 0 : 1; i <= pieces; ++i)
      {
        curve.push_back(toMesh(space.Between(placeOf(from), placeOf(to), static_cast<double>(i) / pieces)));
      }
    }
    result.edges.push_back(std::move(curve));
  }
}

/** Axis ratio of the affine map between two lattices, given the quotients of their periods. */
double
DilatationOf(const Complex & from, const Complex & to)
{
  const double k = std::abs((from - to) / (from - std::conj(to)));
  return (1.0 + k) / (1.0 - k);
}

/** Images of the graph's two periods in the lattice of the surface: the basis with the least dilatation, among those
 * whose coefficients in the reduced basis are at most 2. */
std::array<Complex, 2>
NearestBasis(const Complex & ratio, const std::array<Complex, 2> & periods, double & dilatation)
{
  constexpr int          largest = 2, choices = 2 * largest + 1;
  std::array<Complex, 2> best = periods;
  dilatation = DilatationOf(ratio, periods[1] / periods[0]);
  for (int code = 0; code < choices * choices * choices * choices; ++code)
  {
    std::array<int, 4> m{};
    for (int i = 0, rest = code; i < 4; ++i, rest /= choices)
    {
      m[i] = rest % choices - largest;
    }
    if (m[0] * m[3] - m[1] * m[2] == 1)
    {
      const Complex a = static_cast<double>(m[0]) * periods[0] + static_cast<double>(m[1]) * periods[1];
      const Complex b = static_cast<double>(m[2]) * periods[0] + static_cast<double>(m[3]) * periods[1];
      const double  value = DilatationOf(ratio, b / a);
      if (value < dilatation - 1e-9)
      {
        dilatation = value;
        best = { a, b };
      }
    }
  }
  return best;
}

void
MapTorus(const EmbeddingCertificate & certificate, const SurfaceRicciFlow & flow, GraphOnMesh & result)
{
  const TorusInSpace     torus(certificate);
  const Eigen::MatrixX2d uv = FlatCoordinates(flow.flat, "the flat torus");
  VertexMatrix           places = VertexMatrix::Zero(uv.rows(), 3);
  places.leftCols<2>() = uv;
  const DevelopedMesh          developed(flow.flat, places);
  const std::array<Complex, 2> periods{ Complex(flow.periods[0].x(), flow.periods[0].y()),
                                        Complex(flow.periods[1].x(), flow.periods[1].y()) };
  const auto                   basis = NearestBasis(torus.Period(1) / torus.Period(0), periods, result.dilatation);
  const auto                   toPlane = [&](const Complex & z) {
    const auto [s, t] = torus.Coordinates(z);
    return s * basis[0] + t * basis[1];
  };
  const double size = std::sqrt(flow.area);
  // Lattice translations that take a point near the middle of the development to any of its points.
  const Complex middle(uv.col(0).mean(), uv.col(1).mean());
  const double  reach = (uv.rowwise() - Eigen::RowVector2d(middle.real(), middle.imag())).rowwise().norm().maxCoeff();
  const int     turns = static_cast<int>(std::ceil(2.0 * reach / std::abs(periods[0]))) + 1;
  const int     rows = static_cast<int>(std::ceil(2.0 * reach / periods[1].imag())) + 1;
  const auto    toMesh = [&](const Complex & z) {
    const Complex           w = toPlane(z) - middle;
    const double            t = std::round(w.imag() / periods[1].imag());
    const Complex           v = w - t * periods[1];
    const Complex           base = middle + v - std::round(v.real() / periods[0].real()) * periods[0];
    SurfaceLocator::Closest best;
    best.distance = 1e300;
    for (int j = -rows; j <= rows && best.distance > 1e-12 * size; ++j)
    {
      for (int i = -turns; i <= turns && best.distance > 1e-12 * size; ++i)
      {
        const Complex p = base + static_cast<double>(i) * periods[0] + static_cast<double>(j) * periods[1];
        if (std::abs(p - middle) <= reach * (1.0 + 1e-9))
        {
          const auto closest = developed.Find(Eigen::Vector3d(p.real(), p.imag(), 0.0));
          best = closest.distance < best.distance ? closest : best;
        }
      }
    }
    result.gap = std::max(result.gap, best.distance / size);
    return developed.InSpace(best);
  };
  for (const Complex & z : torus.FlatNodes())
  {
    result.nodes.push_back(toMesh(z));
  }
  const double edge = MeanEdge(places, flow.flat.F);
  for (const std::vector<Complex> & corners : torus.FlatEdges(1))
  {
    std::vector<Eigen::Vector3d> curve;
    for (std::size_t k = 1; k < corners.size(); ++k)
    {
      const Complex from = corners[k - 1], to = corners[k];
      const int     pieces = PiecesOf(std::abs(toPlane(to - from)), edge);
      for (int i = curve.empty() ? 0 : 1; i <= pieces; ++i)
      {
        curve.push_back(toMesh(from + (to - from) * (static_cast<double>(i) / pieces)));
      }
    }
    result.edges.push_back(std::move(curve));
  }
}
} // namespace

GraphOnMesh
MapGraphOntoMesh(const EmbeddingCertificate & certificate, const SurfaceMesh & mesh, const std::string & what)
{
  if (certificate.genus > 1)
  {
    throw InputError(what + ": a graph of genus " + std::to_string(certificate.genus) +
                     " cannot be mapped onto a given surface; only genus 0 and 1 are supported");
  }
  const SurfaceConnectivity connectivity(mesh);
  const auto &              components = connectivity.Components();
  if (components.size() != 1 || !connectivity.IsClosed() || components.front().genus != certificate.genus)
  {
    throw InputError(what + ": it is not a closed surface of genus " + std::to_string(certificate.genus) +
                     ", the genus of the embedding of the graph");
  }
  const SurfaceRicciFlow flow = FlowSurface(mesh, {}, what);
  GraphOnMesh            result;
  result.warnings = flow.warnings;
  if (certificate.genus == 0)
  {
    MapSphere(certificate, flow, result);
  }
  else
  {
    MapTorus(certificate, flow, result);
  }
  return result;
}

void
WriteGraphOnMesh(const GraphOnMesh & graph,
                 const SurfaceMesh & mesh,
                 const Provenance &  facts,
                 const std::string & path)
{
  std::vector<Eigen::Vector3d> points = graph.nodes;
  CurveSet                     set;
  set.curves = CurvesInSpace(graph.edges, points);
  const auto first = static_cast<Eigen::Index>(points.size());
  set.V.resize(first + mesh.V.rows(), 3);
  for (Eigen::Index i = 0; i < first; ++i)
  {
    set.V.row(i) = points[static_cast<std::size_t>(i)].transpose();
  }
  set.V.bottomRows(mesh.V.rows()) = mesh.V;
  set.cellArrays =
    CellArraysInSpace({ graph.nodes.size(), graph.edges.size(), static_cast<std::size_t>(mesh.NumberOfFaces()) });
  set.fieldArrays = { { "dilatation", SurfaceArray::ValueMatrix::Constant(1, 1, graph.dilatation), false } };
  set.facts = facts;
  WriteCurvesOnSurface(std::move(set), mesh.F.array() + static_cast<int>(first), path);
}
} // namespace shapeton
