#include "shapetonMapBuilder.h"

namespace shapeton
{
MapBuilder::MapBuilder(const CombinatorialMap & map) : m_Nodes(map.Nodes()), m_Edges(map.Edges())
{
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    m_Edges[h / 2][h % 2] = map.Node(h);
    m_Next.push_back(map.NextAround(h));
    m_Previous.push_back(map.PreviousAround(h));
  }
}

int
MapBuilder::AddEdge(int from, int to)
{
  const int halfEdge = static_cast<int>(m_Next.size());
  m_Edges.push_back({ from, to });
  for (int h = halfEdge; h < halfEdge + 2; ++h)
  {
    m_Next.push_back(h);
    m_Previous.push_back(h);
  }
  return halfEdge;
}

void
MapBuilder::InsertAfter(int halfEdge, int added)
{
  const int next = m_Next[halfEdge];
  m_Next[halfEdge] = added;
  m_Previous[added] = halfEdge;
  m_Next[added] = next;
  m_Previous[next] = added;
}

void
MapBuilder::SetAround(const std::vector<int> & halfEdges)
{
  for (std::size_t i = 0; i < halfEdges.size(); ++i)
  {
    const int next = halfEdges[(i + 1) % halfEdges.size()];
    m_Next[halfEdges[i]] = next;
    m_Previous[next] = halfEdges[i];
  }
}

void
MapBuilder::Replace(int halfEdge, int by)
{
  const bool isAlone = m_Next[halfEdge] == halfEdge;
  m_Next[by] = isAlone ? by : m_Next[halfEdge];
  m_Previous[by] = isAlone ? by : m_Previous[halfEdge];
  m_Previous[m_Next[by]] = by;
  m_Next[m_Previous[by]] = by;
}

/** At the far end, the half-edge of the last part replaces the old one, which moves to the first dummy. */
std::vector<int>
MapBuilder::Divide(int edge, int parts)
{
  const int                     end = m_Edges[edge][1];
  const int                     replaced = 2 * edge + 1;
  std::vector<int>              path{ 2 * edge };
  std::vector<std::vector<int>> inner;
  int                           node = this->AddNode();
  m_Edges[edge][1] = node;
  int arriving = replaced;
  for (int part = 1; part < parts; ++part)
  {
    const int next = part + 1 < parts ? this->AddNode() : end;
    path.push_back(this->AddEdge(node, next));
    if (part + 1 == parts)
    {
      this->Replace(replaced, path.back() + 1);
    }
    inner.push_back({ arriving, path.back() });
    arriving = path.back() + 1;
    node = next;
  }
  for (const std::vector<int> & around : inner)
  {
    this->SetAround(around);
  }
  return path;
}

CombinatorialMap
MapBuilder::Build() const
{
  return { m_Nodes, m_Edges, m_Next };
}
} // namespace shapeton
