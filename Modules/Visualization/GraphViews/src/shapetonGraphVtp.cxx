#include "shapetonCurveSet.h"
#include "shapetonEmbeddedGraph.h"
#include "shapetonGraphPictures.h"
#include "shapetonPi.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Kinds of cells. */
enum CellKind
{
  NodeCell = 0,
  EdgeCell = 1,
  NodeCircleCell = 2,
  FaceCircleCell = 3
};

/** Maximum distance of a chord from its arc, in units of the surface. The number of corners of a circle and of pieces
 * of half an edge is limited as well. */
constexpr double flatness = 1e-4;
constexpr double fewestCorners = 8.0;
constexpr double mostCorners = 32.0;
constexpr double mostPieces = 6.0;

int
CornersOfCircle(double radius)
{
  return static_cast<int>(std::clamp(std::ceil(Pi * std::sqrt(0.5 * radius / flatness)), fewestCorners, mostCorners));
}

int
PiecesOfGeodesic(double length)
{
  constexpr double ofSagitta = 8.0; // the sagitta of a short arc of radius 1 is length^2 / 8
  return static_cast<int>(std::clamp(std::ceil(length / std::sqrt(ofSagitta * flatness)), 1.0, mostPieces));
}

/** Collects points and cells of a VTP file. */
class CellCollector
{
public:
  void
  Add(CellKind kind, int id, double radius, const std::vector<Place> & points, bool isClosed)
  {
    std::vector<int> curve;
    for (const Place & point : points)
    {
      curve.push_back(static_cast<int>(m_Points.size()));
      m_Points.push_back(point);
    }
    if (isClosed)
    {
      curve.push_back(curve.front());
    }
    m_Curves.push_back(std::move(curve));
    m_Kinds.push_back(kind);
    m_Ids.push_back(id);
    m_Radii.push_back(radius);
  }

  CurveSet
  Take()
  {
    const std::vector<Place> points = std::move(m_Points); // freed early, because there may be tens of millions
    CurveSet                 set;
    set.V.resize(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      set.V.row(static_cast<Eigen::Index>(i)) << points[i].x, points[i].y, points[i].z;
    }
    set.curves = std::move(m_Curves);
    set.cellArrays = { { "kind", Column(m_Kinds), true },
                       { "id", Column(m_Ids), true },
                       { "radius", Column(m_Radii), false } };
    return set;
  }

private:
  static Eigen::VectorXd
  Column(const std::vector<double> & values)
  {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  }

  std::vector<Place>            m_Points;
  std::vector<std::vector<int>> m_Curves;
  std::vector<double>           m_Kinds;
  std::vector<double>           m_Ids;
  std::vector<double>           m_Radii;
};

/** Points along one packed half-edge and its twin, seen from the start node, then from the end node's lift. */
void
AddHalfEdge(const EmbeddedGraph & graph, int halfEdge, int id, CellCollector & cells)
{
  const int          node = graph.map.Node(halfEdge);
  const bool         isStraight = graph.space.Geometry() == EmbeddingGeometry::Euclidean;
  const int          pieces = isStraight ? 1 : PiecesOfGeodesic(graph.certificate.nodeRadii[node]);
  std::vector<Place> points;
  for (int i = 0; i <= pieces; ++i)
  {
    points.push_back(graph.space.Between(graph.nodes[node], graph.touch[halfEdge], i / static_cast<double>(pieces)));
  }
  cells.Add(EdgeCell, id, 0.0, points, false);
}
} // namespace

void
WriteGraphVtp(const EmbeddingCertificate & certificate, const Provenance & facts, const std::string & path)
{
  const EmbeddedGraph graph(certificate);
  const double        unit = UnitOfSurface(certificate);
  const auto          circle = [&](const Place & center, double radius) {
    return graph.space.Circle(center, radius, CornersOfCircle(radius / unit));
  };
  CellCollector cells; // points come first in a VTP file
  for (int node = 0; node < certificate.graph.nodes; ++node)
  {
    cells.Add(NodeCell, node, certificate.nodeRadii[node], { graph.nodes[node] }, false);
  }
  for (int h = 0; h < graph.map.HalfEdges(); ++h)
  {
    if (graph.edgeOf[h / 2] >= 0)
    {
      AddHalfEdge(graph, h, graph.edgeOf[h / 2], cells);
    }
  }
  for (int node = 0; node < certificate.graph.nodes; ++node)
  {
    const double radius = certificate.nodeRadii[node];
    cells.Add(NodeCircleCell, node, radius, circle(graph.nodes[node], radius), true);
  }
  for (std::size_t face = 0; face < graph.faces.size(); ++face)
  {
    const double radius = certificate.faceRadii[face];
    if (graph.isVisibleFace[face] != 0)
    {
      cells.Add(FaceCircleCell, static_cast<int>(face), radius, circle(graph.faces[face], radius), true);
    }
  }
  CurveSet curves = cells.Take();
  curves.facts = facts;
  WriteCurves(std::move(curves), path);
}
} // namespace shapeton
