#include "shapetonTracedMap.h"

#include <numeric>

namespace shapeton
{
UnitedElements::UnitedElements(int size) : m_Parent(size) { std::iota(m_Parent.begin(), m_Parent.end(), 0); }

int
UnitedElements::Find(int element)
{
  while (m_Parent[element] != element)
  {
    m_Parent[element] = m_Parent[m_Parent[element]];
    element = m_Parent[element];
  }
  return element;
}

bool
UnitedElements::Unite(int first, int second)
{
  first = this->Find(first);
  second = this->Find(second);
  m_Parent[first] = second;
  return first != second;
}

TracedMap::TracedMap(const Graph & graph, const std::vector<int> & rotation, const std::string & what)
  : nodes(graph.nodes)
  , next(2 * graph.edges.size(), -1)
  , previous(2 * graph.edges.size(), -1)
  , firstOfNode(graph.nodes, -1)
{
  for (const auto & [first, second] : graph.edges)
  {
    node.insert(node.end(), { first, second });
  }
  for (std::size_t i = 0; i < rotation.size();)
  {
    const std::size_t start = i;
    const int         owner = node[rotation[start]];
    if (firstOfNode[owner] >= 0)
    {
      throw Refusal(what + ": the half-edges of node " + std::to_string(owner) + " are not consecutive");
    }
    firstOfNode[owner] = rotation[start];
    for (; i < rotation.size() && node[rotation[i]] == owner; ++i)
    {
      const bool isLast = i + 1 == rotation.size() || node[rotation[i + 1]] != owner;
      const int  after = isLast ? rotation[start] : rotation[i + 1];
      if (next[rotation[i]] >= 0)
      {
        throw Refusal(what + ": half-edge " + std::to_string(rotation[i]) + " is listed twice");
      }
      next[rotation[i]] = after;
      previous[after] = rotation[i];
    }
  }
  for (int halfEdge = 0; halfEdge < this->HalfEdges(); ++halfEdge)
  {
    if (next[halfEdge] < 0)
    {
      throw Refusal(what + ": half-edge " + std::to_string(halfEdge) + " is missing");
    }
  }
  this->TraceFaces();
  this->CountComponents();
}

void
TracedMap::TraceFaces()
{
  face.assign(node.size(), -1);
  for (int start = 0; start < this->HalfEdges(); ++start)
  {
    if (face[start] >= 0)
    {
      continue;
    }
    for (int halfEdge = start; face[halfEdge] < 0; halfEdge = this->FaceNext(halfEdge))
    {
      face[halfEdge] = static_cast<int>(firstOfFace.size());
    }
    firstOfFace.push_back(start);
  }
}

void
TracedMap::CountComponents()
{
  UnitedElements sets(nodes);
  components = nodes;
  for (int halfEdge = 0; halfEdge < this->HalfEdges(); halfEdge += 2)
  {
    components -= sets.Unite(node[halfEdge], node[halfEdge + 1]) ? 1 : 0;
  }
  for (const int first : firstOfNode)
  {
    isolatedNodes += first < 0 ? 1 : 0;
  }
}

int
TracedMap::Genus() const
{
  const int faces = static_cast<int>(firstOfFace.size()) + isolatedNodes;
  return (2 * components - nodes + this->HalfEdges() / 2 - faces) / 2;
}
} // namespace shapeton
