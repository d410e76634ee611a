#include "shapetonGenusAnnealing.h"

#include <algorithm>
#include <array>
#include <queue>
#include <utility>

namespace shapeton
{
namespace
{
// Exponent during the initial insertion.
constexpr int growthExponent = 3;
constexpr int breadthExponent = 12;
// Number of deferred edges per added handle before the others are retried.
constexpr std::size_t edgesOfAHandle = 256;
// Number of moves between two calls of isInVain.
constexpr int movesBetweenQuestions = 4096;
// Beyond this length, parts of a face are considered equal.
constexpr int longestWalk = 64;
} // namespace

GenusAnnealing::GenusAnnealing(const Graph & graph, PhiloxStream random, Growth growth)
  : m_Graph(graph), m_Random(random), m_Map(graph.nodes, graph.edges)
{
  if (growth == Growth::Tree)
  {
    GrowTree();
  }
  else
  {
    GrowByBreadth();
  }
  InsertRest();
  m_BestGenus = Genus();
  m_Best = m_Map.GetNextAround();
}

int
GenusAnnealing::Genus() const
{
  return (2 - m_Graph.nodes + m_Map.Edges() - m_Map.Faces()) / 2;
}

int
GenusAnnealing::RandomCorner(int node)
{
  int corner = m_Map.Any(node);
  for (int steps = corner < 0 ? 0 : m_Random.Below(m_Map.Degree(node)); steps > 0; --steps)
  {
    corner = m_Map.NextAround(corner);
  }
  return corner;
}

/** A random breadth-first spanning tree from a random node, with random orders. */
void
GenusAnnealing::GrowTree()
{
  const Incidence  incidence(m_Graph);
  std::vector<int> queue{ m_Random.Below(m_Graph.nodes) };
  std::vector<int> leaving;
  for (std::size_t head = 0; head < queue.size(); ++head)
  {
    const int node = queue[head];
    leaving.assign(incidence.halfEdges.begin() + incidence.start[node],
                   incidence.halfEdges.begin() + incidence.start[node + 1]);
    for (std::size_t i = leaving.size(); i > 1; --i)
    {
      std::swap(leaving[i - 1], leaving[m_Random.Below(static_cast<int>(i))]);
    }
    for (const int h : leaving)
    {
      const int neighbor = m_Map.Node(h ^ 1);
      if (neighbor != queue[0] && m_Map.Any(neighbor) < 0)
      {
        const auto [node0, node1] = m_Graph.edges[h / 2];
        const int a = RandomCorner(node0);
        m_Map.Insert(h / 2, a, RandomCorner(node1));
        queue.push_back(neighbor);
      }
    }
  }
}

/** Grows the placed region like a disk on the surface, with short faces inside. The next node is the one with the most
 * neighbors in the region; ties go to the earliest discovered. */
void
GenusAnnealing::GrowByBreadth()
{
  const Incidence                         incidence(m_Graph);
  std::priority_queue<std::array<int, 3>> queue; // neighbors in the region, negative discovery time, node
  std::vector<int>                        placedNeighbors(m_Graph.nodes, 0);
  std::vector<int>                        discovered(m_Graph.nodes, 0);
  int                                     time = 0;
  const int                               root = m_Random.Below(m_Graph.nodes);
  const auto                              leaveFrom = [&](int node) {
    for (int i = incidence.start[node]; i < incidence.start[node + 1]; ++i)
    {
      const int neighbor = m_Map.Node(incidence.halfEdges[i] ^ 1);
      if (neighbor != root && m_Map.Any(neighbor) < 0)
      {
        discovered[neighbor] = discovered[neighbor] == 0 ? ++time : discovered[neighbor];
        queue.push({ ++placedNeighbors[neighbor], -discovered[neighbor], neighbor });
      }
    }
  };
  leaveFrom(root);
  while (!queue.empty())
  {
    const int node = queue.top()[2];
    queue.pop();
    if (m_Map.Any(node) < 0)
    {
      PlaceNode(node, root, incidence);
      leaveFrom(node);
    }
  }
}

/** Inserts all edges to placed nodes, in the face with most of these nodes; edges that need a handle are deferred. */
void
GenusAnnealing::PlaceNode(int node, int root, const Incidence & incidence)
{
  std::vector<int> corners;
  std::vector<int> edges;
  for (int i = incidence.start[node]; i < incidence.start[node + 1]; ++i)
  {
    const int edge = incidence.halfEdges[i] / 2;
    const int neighbor = m_Map.Node(incidence.halfEdges[i] ^ 1);
    if (neighbor == root && m_Map.Any(root) < 0) // first edge
    {
      m_Map.Insert(edge, -1, -1);
    }
    if (m_Map.Contains(edge) || m_Map.Any(neighbor) < 0)
    {
      continue;
    }
    edges.push_back(edge);
    const int first = m_Map.Any(neighbor);
    int       h = first;
    do
    {
      corners.push_back(h);
      h = m_Map.NextAround(h);
    } while (h != first);
  }
  if (m_Map.Any(node) < 0)
  {
    const int corner = CornerForNode(corners);
    for (const int edge : edges)
    {
      const auto [node0, node1] = m_Graph.edges[edge];
      if (m_Map.Node(corner) == (node0 == node ? node1 : node0))
      {
        m_Map.Insert(edge, node0 == node ? -1 : corner, node0 == node ? corner : -1);
        break;
      }
    }
  }
  for (const int edge : edges)
  {
    if (!m_Map.Contains(edge))
    {
      CollectCorners(edge);
      if (!m_Corners.empty())
      {
        Reinsert(edge, breadthExponent);
      }
    }
  }
}

/** A corner in the face that contains most of the given corners; ties go to the longest face. */
int
GenusAnnealing::CornerForNode(const std::vector<int> & corners)
{
  m_FirstOfFace.resize(std::max<std::size_t>(m_FirstOfFace.size(), m_Map.FaceLabels()), -1);
  for (const int h : corners)
  {
    ++m_FirstOfFace[m_Map.Face(h)];
  }
  const auto rank = [this](int h) {
    const int face = m_Map.Face(h);
    return std::make_pair(m_FirstOfFace[face], m_Map.FaceLength(face));
  };
  const int best =
    *std::max_element(corners.begin(), corners.end(), [&rank](int a, int b) { return rank(a) < rank(b); });
  for (const int h : corners)
  {
    m_FirstOfFace[m_Map.Face(h)] = -1;
  }
  return best;
}

int
GenusAnnealing::CornerOfLongestFace(int node) const
{
  int best = m_Map.Any(node);
  for (int h = m_Map.NextAround(best); h != m_Map.Any(node); h = m_Map.NextAround(h))
  {
    if (m_Map.FaceLength(m_Map.Face(h)) > m_Map.FaceLength(m_Map.Face(best)))
    {
      best = h;
    }
  }
  return best;
}

/** First inserts the edges that split a face. Inserts an edge that needs a handle only if all remaining ones do. */
void
GenusAnnealing::InsertRest()
{
  std::vector<int> rest;
  for (int e = 0; e < m_Map.Edges(); ++e)
  {
    if (!m_Map.Contains(e))
    {
      rest.push_back(e);
    }
  }
  for (std::size_t i = rest.size(); i > 1; --i)
  {
    std::swap(rest[i - 1], rest[m_Random.Below(static_cast<int>(i))]);
  }
  std::vector<int> later;
  while (!rest.empty())
  {
    later.clear();
    for (const int e : rest)
    {
      CollectCorners(e);
      if (m_Corners.empty())
      {
        later.push_back(e);
      }
      else
      {
        Reinsert(e, growthExponent);
      }
    }
    if (later.size() == rest.size())
    {
      // A handle merges the longest faces; short faces are kept.
      for (std::size_t handles = 1 + later.size() / edgesOfAHandle; handles > 0; --handles)
      {
        const auto [node0, node1] = m_Graph.edges[later.back()];
        m_Map.Insert(later.back(), CornerOfLongestFace(node0), CornerOfLongestFace(node1));
        later.pop_back();
      }
    }
    rest.swap(later);
  }
}

/** All pairs of corners of the edge's nodes in a common face. */
void
GenusAnnealing::CollectCorners(int edge)
{
  m_Corners.clear();
  m_FirstOfFace.resize(std::max<std::size_t>(m_FirstOfFace.size(), m_Map.FaceLabels()), -1);
  m_NextInFace.resize(2 * m_Graph.edges.size());
  const auto [node0, node1] = m_Graph.edges[edge];
  const auto forCorners = [this](int node, const auto & body) {
    const int first = m_Map.Any(node);
    int       h = first;
    do
    {
      body(h, m_FirstOfFace[m_Map.Face(h)]);
      h = m_Map.NextAround(h);
    } while (h != first);
  };
  forCorners(node1, [this](int h, int & first) {
    m_NextInFace[h] = first;
    first = h;
  });
  forCorners(node0, [this](int h, int first) {
    for (; first >= 0; first = m_NextInFace[first])
    {
      m_Corners.push_back({ h, first });
    }
  });
  forCorners(node1, [](int, int & first) { first = -1; });
}

/** Number of edges between two corners of a face along the shorter way around it, at most longestWalk. */
int
GenusAnnealing::ShorterPart(int a, int b) const
{
  int length = 0;
  int fromA = a;
  int fromB = b;
  do
  {
    fromA = m_Map.FaceNext(fromA);
    fromB = m_Map.FaceNext(fromB);
    ++length;
  } while (fromA != b && fromB != a && length < longestWalk);
  return length;
}

/** Weight of the map with the edge inserted there, relative to the map without it. */
double
GenusAnnealing::WeightOf(const Corners & corners, int exponent) const
{
  const int    length = m_Map.FaceLength(m_Map.Face(corners.after0));
  const int    part = ShorterPart(corners.after0, corners.after1);
  const double ratio = static_cast<double>(length) / (static_cast<double>(part + 1) * (length - part + 1));
  double       weight = 1.0;
  for (int i = 0; i < exponent; ++i)
  {
    weight *= ratio;
  }
  return weight;
}

/** Draws one of m_Corners. \pre m_Corners is not empty. */
GenusAnnealing::Corners
GenusAnnealing::DrawCorners(int exponent)
{
  if (m_Corners.size() == 1)
  {
    return m_Corners[0];
  }
  m_Weights.clear();
  double sum = 0.0;
  for (const Corners & corners : m_Corners)
  {
    m_Weights.push_back(WeightOf(corners, exponent));
    sum += m_Weights.back();
  }
  double      draw = m_Random.Unit() * sum;
  std::size_t i = 0;
  while (i + 1 < m_Corners.size() && draw >= m_Weights[i])
  {
    draw -= m_Weights[i++];
  }
  return m_Corners[i];
}

/** Inserts an edge where it splits a face, if possible, otherwise anywhere. */
void
GenusAnnealing::Reinsert(int edge, int exponent)
{
  CollectCorners(edge);
  if (m_Corners.empty())
  {
    const int a = RandomCorner(m_Graph.edges[edge][0]);
    m_Map.Insert(edge, a, RandomCorner(m_Graph.edges[edge][1]));
    return;
  }
  const Corners corners = DrawCorners(exponent);
  m_Map.Insert(edge, corners.after0, corners.after1);
}

void
GenusAnnealing::KeepBest()
{
  if (Genus() < m_BestGenus)
  {
    m_BestGenus = Genus();
    m_Best = m_Map.GetNextAround();
  }
}

void
GenusAnnealing::Anneal(std::int64_t moves, int lastExponent, int goal, const std::function<bool()> & isInVain)
{
  const int firstExponent = lastExponent / 2;
  for (std::int64_t move = 0; move < moves && m_BestGenus > goal; ++move)
  {
    if (move % movesBetweenQuestions == 0 && isInVain())
    {
      return;
    }
    const int edge = m_Random.Below(m_Map.Edges());
    m_Map.Remove(edge);
    Reinsert(edge, firstExponent + static_cast<int>((lastExponent - firstExponent + 1) * move / moves));
    KeepBest();
  }
}
} // namespace shapeton
