#include "shapetonSurfaceLayout.h"

#include "shapetonDisjointSets.h"
#include "shapetonLayoutTree.h"
#include "shapetonParallelFor.h"
#include "shapetonPi.h"

#include <algorithm>

namespace shapeton
{
SurfaceLayout::SurfaceLayout(const CombinatorialMap & map, const CirclePacking & packing)
  : m_Map(map), m_Packing(packing), m_Angles(HalfEdgeAngles(map, packing)), m_Frames(map.Nodes())
{
  const LayoutTree    tree = LayoutTree::OfShortestPaths(map, packing);
  std::vector<double> distances(map.Nodes(), 0.0);
  m_Arrivals = tree.arrival;
  m_Frames[tree.order.front()] = PlaneMotion::Rotation(packing.geometry, 0.0);
  for (const int node : tree.order)
  {
    const int arrival = m_Arrivals[node];
    if (arrival >= 0)
    {
      const int before = map.Node(arrival);
      m_Frames[node] = this->FrameAcross(arrival);
      distances[node] = distances[before] + packing.nodeRadii[before] + packing.nodeRadii[node];
    }
  }
  this->FindCut(distances);
}

PlaneMotion
SurfaceLayout::FrameAcross(int halfEdge) const
{
  const FlowGeometry geometry = m_Packing.geometry;
  const int          from = m_Map.Node(halfEdge);
  const int          twin = CombinatorialMap::Twin(halfEdge);
  const double       length = m_Packing.nodeRadii[from] + m_Packing.nodeRadii[m_Map.Node(twin)];
  return (m_Frames[from] * PlaneMotion::Rotation(geometry, m_Angles[halfEdge]) *
          PlaneMotion::Translation(geometry, length) * PlaneMotion::Rotation(geometry, Pi - m_Angles[twin]))
    .Normalized();
}

PlaneMotion
SurfaceLayout::DeckTransformationOf(int halfEdge) const
{
  return (this->FrameAcross(halfEdge) * m_Frames[m_Map.Node(CombinatorialMap::Twin(halfEdge))].Inverse()).Normalized();
}

PlaneMotion::Complex
SurfaceLayout::FaceCenter(int face) const
{
  const FlowGeometry geometry = m_Packing.geometry;
  const int          h = m_Map.FirstOfFace(face);
  const double       node = m_Packing.nodeRadii[m_Map.Node(h)];
  const double       radius = m_Packing.faceRadii[face];
  const double       distance = geometry == FlowGeometry::Euclidean
                                  ? std::hypot(node, radius)
                                  : std::asinh(std::hypot(std::sinh(node) * std::cosh(radius), std::sinh(radius)));
  const double       angle = m_Angles[h] + HalfKiteAngle(geometry, node, radius);
  return (m_Frames[m_Map.Node(h)] * PlaneMotion::Rotation(geometry, angle) *
          PlaneMotion::Translation(geometry, distance))(0.0);
}

/** Crosses edges outside the tree, from the longest loop to the shortest, if that joins two faces. */
void
SurfaceLayout::FindCut(const std::vector<double> & distances)
{
  std::vector<char> isCrossed(m_Map.Edges(), 1);
  for (const int arrival : m_Arrivals)
  {
    if (arrival >= 0)
    {
      isCrossed[arrival / 2] = 0;
    }
  }
  std::vector<int>    edges;
  std::vector<double> length(m_Map.Edges(), 0.0);
  for (int edge = 0; edge < m_Map.Edges(); ++edge)
  {
    if (isCrossed[edge])
    {
      const int from = m_Map.Node(2 * edge);
      const int to = m_Map.Node(2 * edge + 1);
      length[edge] = distances[from] + distances[to] + m_Packing.nodeRadii[from] + m_Packing.nodeRadii[to];
      edges.push_back(edge);
    }
  }
  std::stable_sort(edges.begin(), edges.end(), [&](int a, int b) { return length[a] > length[b]; });
  DisjointSets sets(m_Map.Faces());
  for (const int edge : edges)
  {
    if (!sets.Join(m_Map.Face(2 * edge), m_Map.Face(2 * edge + 1)))
    {
      isCrossed[edge] = 0;
      m_Cut.push_back(2 * edge);
    }
  }
  std::sort(m_Cut.begin(), m_Cut.end());
  this->ReadWord(isCrossed);
}

/** Walks around the single face of the map of the uncrossed edges. */
void
SurfaceLayout::ReadWord(const std::vector<char> & isCrossed)
{
  const int start = m_Cut.front();
  int       h = start;
  do
  {
    const auto place = std::lower_bound(m_Cut.begin(), m_Cut.end(), h & ~1);
    if (place != m_Cut.end() && *place == (h & ~1))
    {
      const int letter = static_cast<int>(place - m_Cut.begin()) + 1;
      m_Word.push_back(h & 1 ? -letter : letter);
    }
    h = m_Map.FaceNext(h);
    while (isCrossed[h / 2])
    {
      h = m_Map.PreviousAround(h);
    }
  } while (h != start);
}

std::array<std::complex<double>, 2>
ReducedLattice(std::complex<double> w1, std::complex<double> w2)
{
  for (int i = 0; i < 1000; ++i)
  {
    if (std::norm(w2) < std::norm(w1))
    {
      std::swap(w1, w2);
    }
    const double times = std::round((std::conj(w1) * w2).real() / std::norm(w1));
    if (times == 0.0)
    {
      break;
    }
    w2 -= times * w1;
  }
  return { w1, (std::conj(w1) * w2).imag() < 0.0 ? -w2 : w2 };
}
} // namespace shapeton
