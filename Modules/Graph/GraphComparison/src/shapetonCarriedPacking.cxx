#include "shapetonCarriedPacking.h"

#include "shapetonDummyColumns.h"
#include "shapetonRoomForEdges.h"

#include <algorithm>
#include <utility>

namespace shapeton
{
namespace
{
/** Each ring has half as many dummies as the one around it, so in a face of 2^8 half-edges every dummy is within this
 * reach of a change. */
constexpr int farthestReach = 8;

/** Maximum share of deleted edges that are replaced by columns of dummies. Chosen: with a tenth, nodes of a sensor
 * network move more with columns (0.093 rad on average) than without (0.076). */
constexpr double mostShareOfColumns = 0.05;
/** Maximum number of dummies to which columns are added; limits the time of many steps. */
constexpr int mostDummies = 10000;

/** The new graph and the reused dummies, as a map. */
class CarriedMap
{
public:
  CarriedMap(const PackedMap & packed, const Graph & after, const CombinatorialMap & map, StepMatch match, int reach)
    : m_Packed(packed.map)
    , m_Map(map)
    , m_Match(std::move(match))
    , m_Dummies(packed.map, packed.graphNodes)
    , m_Stretches(packed.map, map, m_Match, m_Dummies, reach)
    , m_Graph{ after.nodes, after.edges, {} }
  {
    const std::vector<DummyWay> ways = MakeRoomForEdges(m_Packed, m_Map, m_Match, m_Stretches, m_Dummies);
    this->AddDummies(ways);
  }

  CombinatorialMap
  Build() const;
  /** Same as in PackedMap. */
  const std::vector<std::vector<int>> &
  Subdivided() const
  {
    return m_Subdivided;
  }

private:
  void
  AddDummies(const std::vector<DummyWay> & ways);
  void
  BeginWay(const DummyWay & way);
  void
  EndWay(const DummyWay & way);
  void
  Append(const DummyStretch * stretch, std::vector<int> & order) const;
  std::vector<int>
  OrderOfNode(int node) const;
  std::vector<int>
  OrderOfDummy(int dummy) const;

  const CombinatorialMap & m_Packed;
  const CombinatorialMap & m_Map;
  StepMatch                m_Match; ///< includes dummies and their half-edges, once added
  FaceDummies              m_Dummies;
  DummyStretches           m_Stretches;
  Graph                    m_Graph;

  std::vector<std::vector<int>> m_Subdivided;
};

/** A path starts with the edge itself, which now ends at the first dummy. */
void
CarriedMap::BeginWay(const DummyWay & way)
{
  const int first = way.halfEdges.front();
  m_Match.halfEdgeOf[first] = 2 * way.edge;
  m_Match.halfEdgeOf[CombinatorialMap::Twin(first)] = 2 * way.edge + 1;
  m_Graph.edges[way.edge][1] = m_Match.nodeOf[m_Dummies.Head(first)];
}

void
CarriedMap::EndWay(const DummyWay & way)
{
  m_Subdivided.emplace_back();
  for (const int h : way.halfEdges)
  {
    m_Subdivided.back().push_back(m_Match.halfEdgeOf[h]);
  }
}

void
CarriedMap::AddDummies(const std::vector<DummyWay> & ways)
{
  std::vector<int> & nodeOf = m_Match.nodeOf;
  for (int dummy = static_cast<int>(nodeOf.size()); dummy < m_Packed.Nodes(); ++dummy)
  {
    nodeOf.push_back(m_Dummies.Stays(dummy) ? m_Graph.nodes++ : -1);
  }
  std::for_each(ways.begin(), ways.end(), [this](const DummyWay & way) { this->BeginWay(way); });
  for (int h = 0; h < m_Packed.HalfEdges(); h += 2)
  {
    const int  from = m_Packed.Node(h);
    const int  to = m_Dummies.Head(h);
    const bool isOfDummy = m_Dummies.IsDummy(from) || m_Dummies.IsDummy(to);
    if (isOfDummy && nodeOf[from] >= 0 && nodeOf[to] >= 0 && m_Match.halfEdgeOf[h] < 0)
    {
      m_Match.halfEdgeOf[h] = static_cast<int>(2 * m_Graph.edges.size());
      m_Match.halfEdgeOf[h + 1] = m_Match.halfEdgeOf[h] + 1;
      m_Graph.edges.push_back({ nodeOf[from], nodeOf[to] });
    }
  }
  std::for_each(ways.begin(), ways.end(), [this](const DummyWay & way) { this->EndWay(way); });
}

/** Elements of a stretch in the new map. */
void
CarriedMap::Append(const DummyStretch * stretch, std::vector<int> & order) const
{
  if (!stretch)
  {
    return;
  }
  int        next = 0; // index of a dummy
  const auto appendDummiesTo = [&](int end) {
    for (; next < end; ++next)
    {
      if (const int h = m_Match.halfEdgeOf[stretch->dummies[next]]; h >= 0)
      {
        order.push_back(h);
      }
    }
  };
  for (std::size_t i = 0; i < stretch->added.size(); ++i)
  {
    appendDummiesTo(stretch->places[i]);
    const int way = stretch->places[i] < 0 ? -1 : m_Match.halfEdgeOf[stretch->dummies[next++]];
    order.push_back(way < 0 ? stretch->added[i] : way);
  }
  appendDummiesTo(static_cast<int>(stretch->dummies.size()));
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
HasLoops(const Graph & graph)
{
  return std::any_of(graph.edges.begin(), graph.edges.end(), [](const auto & ends) { return ends[0] == ends[1]; });
}

/** A graph and a map of it. */
struct DrawnGraph
{
  Graph            graph;
  CombinatorialMap map;
};

/** Elements of a graph that also exist in the previous step. */
DrawnGraph
CommonPart(const Graph & after, const CombinatorialMap & map, const StepMatch & match)
{
  Graph            graph;
  std::vector<int> nodeOf(after.nodes, -1);
  std::vector<int> halfEdgeOf(map.HalfEdges(), -1);
  for (int node = 0; node < after.nodes; ++node)
  {
    if (match.oldNode[node] >= 0)
    {
      nodeOf[node] = graph.nodes++;
      graph.names.push_back(NameOfNode(after, node));
    }
  }
  for (int h = 0; h < map.HalfEdges(); h += 2)
  {
    if (match.oldHalfEdge[h] >= 0)
    {
      halfEdgeOf[h] = static_cast<int>(2 * graph.edges.size());
      halfEdgeOf[h + 1] = halfEdgeOf[h] + 1;
      graph.edges.push_back({ nodeOf[map.Node(h)], nodeOf[map.Node(h + 1)] });
    }
  }
  Rotation rotation(graph.nodes);
  for (int node = 0; node < after.nodes; ++node)
  {
    for (const int h : map.Around(node))
    {
      if (halfEdgeOf[h] >= 0)
      {
        rotation[nodeOf[node]].push_back(halfEdgeOf[h]);
      }
    }
  }
  return { graph, CombinatorialMap(graph, rotation) };
}

/** Marks the edges that are gone although both ends stay. */
std::vector<char>
DeletedEdges(const Graph & before, const StepMatch & match)
{
  std::vector<char> isDeleted;
  for (std::size_t e = 0; e < before.edges.size(); ++e)
  {
    const auto & [a, b] = before.edges[e];
    isDeleted.push_back(match.halfEdgeOf[2 * e] < 0 && match.nodeOf[a] >= 0 && match.nodeOf[b] >= 0);
  }
  return isDeleted;
}

/** Removes increasing numbers of dummies until the remaining ones fit the map. */
PackedMap
Carry(const Graph & before, const PackedMap & packed, const Graph & after, const CombinatorialMap & map)
{
  const StepMatch match(before, packed, after, map);
  for (int reach = 0; reach <= farthestReach; ++reach)
  {
    const CarriedMap       carried(packed, after, map, match, reach);
    const CombinatorialMap withDummies = carried.Build();
    if (withDummies.Genus() == map.Genus())
    {
      PackedMap result = MakePackedMap(withDummies, FilledFaces());
      result.graphNodes = map.Nodes();
      result.graphEdges = map.Edges();
      result.subdivided = carried.Subdivided();
      return result;
    }
  }
  return MakePackedMap(map, FilledFaces());
}
} // namespace

AugmentationOptions
FilledFaces()
{
  AugmentationOptions options;
  options.longestFace = 6;
  return options;
}

PackedMap
CarryPackedMap(const Graph & before, const PackedMap & packed, const Graph & after, const CombinatorialMap & map)
{
  if (HasLoops(before) || HasLoops(after))
  {
    return MakePackedMap(map, FilledFaces());
  }
  const ParallelEdges     old(before);
  const ParallelEdges     edited(after);
  const Graph &           graph = edited.Simple();
  const CombinatorialMap  simple = edited.Simple(map);
  PackedGraph             held{ old.Simple(), old.Simple(packed) };
  const std::vector<char> isDeleted = DeletedEdges(held.graph, StepMatch(held.graph, held.packed, graph, simple));
  if (std::count(isDeleted.begin(), isDeleted.end(), 1) <= mostShareOfColumns * held.graph.edges.size() &&
      packed.map.Nodes() - packed.graphNodes < mostDummies)
  {
    held = WithColumns(held.graph, held.packed, isDeleted);
  }
  const DrawnGraph common = CommonPart(graph, simple, StepMatch(held.graph, held.packed, graph, simple));
  if (common.graph.nodes == 0)
  {
    return MakePackedMap(map, FilledFaces());
  }
  const PackedMap kept = Carry(held.graph, held.packed, common.graph, common.map);
  return edited.Restored(Carry(common.graph, kept, graph, simple));
}
} // namespace shapeton
