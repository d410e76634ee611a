#include "itkCarriedPacking.h"

#include "itkGraphStructure.h"
#include "itkPackingCarrier.h"

namespace itk
{
void
PackingCarrier::NumberDummies()
{
  m_NodeOf.resize(m_Old.Nodes(), -1);
  for (int dummy = m_OldNodes; dummy < m_Old.Nodes(); ++dummy)
  {
    m_NodeOf[dummy] = this->Stays(dummy) ? m_Graph.nodes++ : -1;
  }
  for (int h = 0; h < m_Old.HalfEdges(); h += 2)
  {
    const int from = m_Old.Node(h);
    const int to = this->OldHead(h);
    if ((this->IsDummy(from) || this->IsDummy(to)) && m_NodeOf[from] >= 0 && m_NodeOf[to] >= 0)
    {
      m_HalfEdgeOf[h] = static_cast<int>(2 * m_Graph.edges.size());
      m_HalfEdgeOf[h + 1] = m_HalfEdgeOf[h] + 1;
      m_Graph.edges.push_back({ m_NodeOf[from], m_NodeOf[to] });
    }
  }
}

/** What a stretch has in the new map. */
void
PackingCarrier::Append(int stretch, std::vector<int> & order) const
{
  if (stretch < 0)
  {
    return;
  }
  const Stretch & own = m_Stretches[stretch];
  if (own.place < 0)
  {
    order.insert(order.end(), own.added.begin(), own.added.end()); // no dummy has stayed, or nothing is added
  }
  for (std::size_t i = 0; i < own.dummies.size(); ++i)
  {
    if (static_cast<int>(i) == own.place)
    {
      order.push_back(own.added.front());
    }
    else if (m_HalfEdgeOf[own.dummies[i]] >= 0)
    {
      order.push_back(m_HalfEdgeOf[own.dummies[i]]);
    }
  }
}

std::vector<int>
PackingCarrier::OrderOfNode(int node) const
{
  if (m_OldNode[node] < 0)
  {
    return m_Map.Around(node);
  }
  std::vector<int> order;
  this->Append(m_LoneStretch[node], order);
  for (const int h : m_Map.Around(node))
  {
    if (m_OldHalfEdge[h] >= 0)
    {
      order.push_back(h);
      this->Append(m_StretchOf[h], order);
    }
  }
  return order;
}

std::vector<int>
PackingCarrier::OrderOfDummy(int dummy) const
{
  std::vector<int> order;
  for (const int h : m_Old.Around(dummy))
  {
    if (m_HalfEdgeOf[h] >= 0)
    {
      order.push_back(m_HalfEdgeOf[h]);
    }
  }
  return order;
}

CombinatorialMap
PackingCarrier::Build() const
{
  Rotation rotation;
  for (int node = 0; node < m_After.nodes; ++node)
  {
    rotation.push_back(this->OrderOfNode(node));
  }
  for (int dummy = m_OldNodes; dummy < m_Old.Nodes(); ++dummy)
  {
    if (m_NodeOf[dummy] >= 0)
    {
      rotation.push_back(this->OrderOfDummy(dummy));
    }
  }
  return { m_Graph, rotation };
}
PackedMap
CarryPackedMap(const Graph & before, const PackedMap & packed, const Graph & after, const CombinatorialMap & map)
{
  const std::vector<int> first = FirstParallels(after);
  bool                   isSimple = packed.subdivided.empty();
  for (std::size_t e = 0; e < first.size() && isSimple; ++e)
  {
    isSimple = first[e] == static_cast<int>(e);
  }
  if (isSimple)
  {
    const CombinatorialMap carried = PackingCarrier(before, packed, after, map).Build();
    if (carried.Genus() == map.Genus())
    {
      AugmentationOptions options;
      options.firstDummy = map.Nodes();
      PackedMap result = MakePackedMap(carried, options);
      result.graphNodes = map.Nodes();
      result.graphEdges = map.Edges();
      return result;
    }
  }
  return MakePackedMap(map);
}
} // namespace itk
