#include "itkCurveSet.h"
#include "itkEmbeddedGraph.h"
#include "itkGraphPictures.h"

namespace itk
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
    CurveSet set;
    set.V.resize(static_cast<Eigen::Index>(m_Points.size()), 3);
    for (std::size_t i = 0; i < m_Points.size(); ++i)
    {
      set.V.row(static_cast<Eigen::Index>(i)) << m_Points[i].x, m_Points[i].y, m_Points[i].z;
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

/** Points along one packed half-edge and its twin: seen from the start node, then from the end node's lift. */
void
AddHalfEdge(const EmbeddedGraph & graph, int halfEdge, int id, CellCollector & cells)
{
  constexpr int      pieces = 6;
  std::vector<Place> points;
  const int          last = graph.space.Geometry() == EmbeddingGeometry::Euclidean ? 1 : pieces;
  for (int i = 0; i <= last; ++i)
  {
    points.push_back(
      graph.space.Between(graph.nodes[graph.map.Node(halfEdge)], graph.touch[halfEdge], i / static_cast<double>(last)));
  }
  cells.Add(EdgeCell, id, 0.0, points, false);
}
} // namespace

void
WriteGraphVtp(const EmbeddingCertificate &                             certificate,
              const std::vector<std::pair<std::string, std::string>> & facts,
              const std::string &                                      path)
{
  constexpr int       corners = 32; // of a circle
  const EmbeddedGraph graph(certificate);
  std::vector<int>    edgeOf(certificate.packed.edges.size(), -1); // of packed edges that belong to one of the graph
  for (std::size_t e = 0; e < certificate.graph.edges.size(); ++e)
  {
    edgeOf[e] = static_cast<int>(e);
  }
  for (const std::vector<int> & part : certificate.subdivided)
  {
    for (const int h : part)
    {
      edgeOf[h / 2] = part.front() / 2;
    }
  }
  CellCollector cells; // points come first in a VTP file
  for (int node = 0; node < certificate.graph.nodes; ++node)
  {
    cells.Add(NodeCell, node, certificate.nodeRadii[node], { graph.nodes[node] }, false);
  }
  for (int h = 0; h < graph.map.HalfEdges(); ++h)
  {
    if (edgeOf[h / 2] >= 0)
    {
      AddHalfEdge(graph, h, edgeOf[h / 2], cells);
    }
  }
  for (int node = 0; node < certificate.graph.nodes; ++node)
  {
    const double radius = certificate.nodeRadii[node];
    cells.Add(NodeCircleCell, node, radius, graph.space.Circle(graph.nodes[node], radius, corners), true);
  }
  for (std::size_t face = 0; face < graph.faces.size(); ++face)
  {
    const double radius = certificate.faceRadii[face];
    if (graph.isVisibleFace[face] != 0)
    {
      cells.Add(
        FaceCircleCell, static_cast<int>(face), radius, graph.space.Circle(graph.faces[face], radius, corners), true);
    }
  }
  CurveSet curves = cells.Take();
  curves.facts = facts;
  WriteCurves(curves, path);
}
} // namespace itk
