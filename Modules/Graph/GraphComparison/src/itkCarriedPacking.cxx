#include "itkCarriedPacking.h"

#include "itkGraphStructure.h"
#include "itkRoomForEdges.h"

namespace itk
{
namespace
{
/** The new graph, and the dummies that stay, as a map. */
class CarriedMap
{
public:
  CarriedMap(const Graph & before, const PackedMap & packed, const Graph & after, const CombinatorialMap & map)
    : m_Packed(packed.map)
    , m_Map(map)
    , m_Match(before, packed, after, map)
    , m_Dummies(packed.map, packed.graphNodes)
    , m_Stretches(packed.map, map, m_Match, m_Dummies)
    , m_Graph{ after.nodes, after.edges, {} }
  {
    MakeRoomForEdges(m_Packed, m_Map, m_Match, m_Stretches, m_Dummies);
    this->AddDummies();
  }

  CombinatorialMap
  Build() const;

private:
  void
  AddDummies();
  void
  Append(const DummyStretch * stretch, std::vector<int> & order) const;
  std::vector<int>
  OrderOfNode(int node) const;
  std::vector<int>
  OrderOfDummy(int dummy) const;

  const CombinatorialMap & m_Packed;
  const CombinatorialMap & m_Map;
  StepMatch                m_Match; ///< of dummies and their half-edges, too, once they are added
  FaceDummies              m_Dummies;
  DummyStretches           m_Stretches;
  Graph                    m_Graph;
};

void
CarriedMap::AddDummies()
{
  std::vector<int> & nodeOf = m_Match.nodeOf;
  for (int dummy = static_cast<int>(nodeOf.size()); dummy < m_Packed.Nodes(); ++dummy)
  {
    nodeOf.push_back(m_Dummies.Stays(dummy) ? m_Graph.nodes++ : -1);
  }
  for (int h = 0; h < m_Packed.HalfEdges(); h += 2)
  {
    const int from = m_Packed.Node(h);
    const int to = m_Dummies.Head(h);
    if ((m_Dummies.IsDummy(from) || m_Dummies.IsDummy(to)) && nodeOf[from] >= 0 && nodeOf[to] >= 0)
    {
      m_Match.halfEdgeOf[h] = static_cast<int>(2 * m_Graph.edges.size());
      m_Match.halfEdgeOf[h + 1] = m_Match.halfEdgeOf[h] + 1;
      m_Graph.edges.push_back({ nodeOf[from], nodeOf[to] });
    }
  }
}

/** What a stretch has in the new map. */
void
CarriedMap::Append(const DummyStretch * stretch, std::vector<int> & order) const
{
  if (!stretch)
  {
    return;
  }
  if (stretch->place < 0)
  {
    order.insert(order.end(), stretch->added.begin(), stretch->added.end()); // no dummy has stayed, or nothing is added
  }
  for (std::size_t i = 0; i < stretch->dummies.size(); ++i)
  {
    if (static_cast<int>(i) == stretch->place)
    {
      order.push_back(stretch->added.front());
    }
    else if (m_Match.halfEdgeOf[stretch->dummies[i]] >= 0)
    {
      order.push_back(m_Match.halfEdgeOf[stretch->dummies[i]]);
    }
  }
}

std::vector<int>
CarriedMap::OrderOfNode(int node) const
{
  if (m_Match.oldNode[node] < 0)
  {
    return m_Map.Around(node);
  }
  std::vector<int> order;
  this->Append(m_Stretches.Around(node), order);
  for (const int h : m_Map.Around(node))
  {
    if (m_Match.oldHalfEdge[h] >= 0)
    {
      order.push_back(h);
      this->Append(m_Stretches.Of(h), order);
    }
  }
  return order;
}

std::vector<int>
CarriedMap::OrderOfDummy(int dummy) const
{
  std::vector<int> order;
  for (const int h : m_Packed.Around(dummy))
  {
    if (m_Match.halfEdgeOf[h] >= 0)
    {
      order.push_back(m_Match.halfEdgeOf[h]);
    }
  }
  return order;
}

CombinatorialMap
CarriedMap::Build() const
{
  Rotation rotation;
  for (int node = 0; node < m_Map.Nodes(); ++node)
  {
    rotation.push_back(this->OrderOfNode(node));
  }
  for (int node = 0; node < m_Packed.Nodes(); ++node)
  {
    if (m_Dummies.IsDummy(node) && m_Dummies.Stays(node))
    {
      rotation.push_back(this->OrderOfDummy(node));
    }
  }
  return { m_Graph, rotation };
}

bool
IsSimple(const Graph & graph)
{
  const std::vector<int> first = FirstParallels(graph);
  for (std::size_t e = 0; e < first.size(); ++e)
  {
    if (first[e] != static_cast<int>(e))
    {
      return false;
    }
  }
  return true;
}
} // namespace

PackedMap
CarryPackedMap(const Graph & before, const PackedMap & packed, const Graph & after, const CombinatorialMap & map)
{
  if (packed.subdivided.empty() && IsSimple(after))
  {
    const CombinatorialMap carried = CarriedMap(before, packed, after, map).Build();
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
