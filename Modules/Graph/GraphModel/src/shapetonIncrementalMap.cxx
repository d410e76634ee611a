#include "shapetonIncrementalMap.h"

#include <utility>

namespace shapeton
{
IncrementalMap::IncrementalMap(int nodes, const std::vector<std::array<int, 2>> & edges)
  : m_Any(nodes, -1), m_Degree(nodes, 0)
{
  for (const auto & edge : edges)
  {
    AddEdge(edge[0], edge[1]);
  }
}

IncrementalMap::IncrementalMap(const CombinatorialMap & map)
  : RotationSystem(map), m_Any(map.Nodes()), m_Degree(map.Degrees()), m_Length(map.FaceLengths()), m_Faces(map.Faces())
{
  for (int v = 0; v < map.Nodes(); ++v)
  {
    m_Any[v] = map.FirstAround(v);
  }
}

int
IncrementalMap::AddEdge(int node0, int node1)
{
  m_Node.insert(m_Node.end(), { node0, node1 });
  for (std::vector<int> * links : { &m_Next, &m_Previous, &m_Face })
  {
    links->insert(links->end(), 2, -1);
  }
  return Edges() - 1;
}

void
IncrementalMap::Link(int halfEdge, int after)
{
  const int node = m_Node[halfEdge];
  if (after < 0)
  {
    m_Next[halfEdge] = m_Previous[halfEdge] = halfEdge;
    m_Any[node] = halfEdge;
  }
  else
  {
    const int before = m_Next[after];
    m_Next[after] = halfEdge;
    m_Previous[halfEdge] = after;
    m_Next[halfEdge] = before;
    m_Previous[before] = halfEdge;
  }
  ++m_Degree[node];
}

void
IncrementalMap::Unlink(int halfEdge)
{
  const int node = m_Node[halfEdge];
  const int next = m_Next[halfEdge];
  if (next == halfEdge)
  {
    m_Any[node] = -1;
  }
  else
  {
    m_Next[m_Previous[halfEdge]] = next;
    m_Previous[next] = m_Previous[halfEdge];
    m_Any[node] = next;
  }
  m_Next[halfEdge] = m_Previous[halfEdge] = -1;
  --m_Degree[node];
}

int
IncrementalMap::NewLabel()
{
  if (m_FreeLabels.empty())
  {
    m_Length.push_back(0);
    return FaceLabels() - 1;
  }
  const int label = m_FreeLabels.back();
  m_FreeLabels.pop_back();
  return label;
}

void
IncrementalMap::Relabel(int start, int label)
{
  int h = start;
  do
  {
    m_Face[h] = label;
    h = FaceNext(h);
  } while (h != start);
}

/** Assigns a common label to the faces of two half-edges, and returns it. */
int
IncrementalMap::Join(int one, int other)
{
  if (m_Length[m_Face[one]] < m_Length[m_Face[other]])
  {
    std::swap(one, other);
  }
  const int kept = m_Face[one];
  const int lost = m_Face[other];
  if (kept != lost)
  {
    Relabel(other, kept);
    m_Length[kept] += m_Length[lost];
    m_FreeLabels.push_back(lost);
    --m_Faces;
  }
  return kept;
}

/** Splits the label of two half-edges that are now in two faces. Walks around both at once until the shorter one
 * closes. */
void
IncrementalMap::Divide(int one, int other)
{
  const int label = m_Face[one];
  int       a = one;
  int       b = other;
  int       length = 0;
  do
  {
    a = FaceNext(a);
    b = FaceNext(b);
    ++length;
  } while (a != one && b != other);
  const int fresh = NewLabel();
  Relabel(a == one ? one : other, fresh);
  m_Length[fresh] = length;
  m_Length[label] -= length;
  ++m_Faces;
}

void
IncrementalMap::Insert(int edge, int a, int b)
{
  const int one = 2 * edge;
  const int other = one + 1;
  if (a < 0 && b < 0)
  {
    Link(one, a);
    Link(other, b);
    m_Face[one] = m_Face[other] = NewLabel();
    m_Length[m_Face[one]] = 2;
    ++m_Faces;
    return;
  }
  const bool divides = a >= 0 && b >= 0 && m_Face[a] == m_Face[b];
  const int  kept = Join(a < 0 ? b : a, b < 0 ? a : b);
  Link(one, a);
  Link(other, b);
  m_Face[one] = m_Face[other] = kept;
  m_Length[kept] += 2;
  if (divides)
  {
    Divide(one, other);
  }
}

void
IncrementalMap::Remove(int edge)
{
  const int one = 2 * edge;
  const int other = one + 1;
  // Corners that remain at the ends of the edge, each given by the half-edge before it.
  const int  a = m_Previous[one] == one ? -1 : m_Previous[one];
  const int  b = m_Previous[other] == other ? -1 : m_Previous[other];
  const bool divides = a >= 0 && b >= 0 && m_Face[one] == m_Face[other];
  const int  kept = Join(one, other);
  Unlink(one);
  Unlink(other);
  m_Length[kept] -= 2;
  if (a < 0 && b < 0)
  {
    m_FreeLabels.push_back(kept);
    --m_Faces;
  }
  if (divides)
  {
    Divide(a, b);
  }
}
} // namespace shapeton
