#include "shapetonSplitArrangement.h"

#include "shapetonBlockMaps.h"

#include <algorithm>
#include <deque>
#include <numeric>

namespace shapeton
{
namespace
{
/** The blocks of a map as separate components: a node is copied for each block that contains it. */
struct PartedMap
{
  explicit PartedMap(const CombinatorialMap & map)
  {
    BlockMaps        blocks(map);
    std::vector<int> nodeOf(map.HalfEdges(), -1);
    for (int start = 0; start < map.HalfEdges(); ++start)
    {
      if (nodeOf[start] < 0)
      {
        for (int h = start; nodeOf[h] < 0; h = blocks.next[h])
        {
          nodeOf[h] = static_cast<int>(original.size());
        }
        original.push_back(map.Node(start));
      }
    }
    std::vector<std::array<int, 2>> edges(map.Edges());
    for (int e = 0; e < map.Edges(); ++e)
    {
      edges[e] = { nodeOf[2 * e], nodeOf[2 * e + 1] };
    }
    parts = CombinatorialMap(static_cast<int>(original.size()), edges, std::move(blocks.next));
  }
  CombinatorialMap parts;
  std::vector<int> original; ///< node of the given map, for each node of `parts`
};

using NodePair = std::array<int, 2>;

/** Nodes that share at least three faces in a planar block, ascending. */
std::vector<NodePair>
SplitPairs(const CombinatorialMap & parts)
{
  const std::vector<int> degrees = parts.Degrees();
  std::vector<int>       common(parts.Nodes(), 0);
  std::vector<NodePair>  pairs;
  for (int node = 0; node < parts.Nodes(); ++node)
  {
    if (degrees[node] < 3 || parts.GenusOfComponent()[parts.ComponentOfNode()[node]] > 0)
    {
      continue;
    }
    std::vector<int> met;
    for (const int h : parts.Around(node))
    {
      for (int onFace = parts.FaceNext(h); onFace != h; onFace = parts.FaceNext(onFace))
      {
        const int other = parts.Node(onFace);
        if (other > node && degrees[other] >= 3 && common[other]++ == 0)
        {
          met.push_back(other);
        }
      }
    }
    std::sort(met.begin(), met.end());
    for (const int other : met)
    {
      if (common[other] >= 3)
      {
        pairs.push_back({ node, other });
      }
      common[other] = 0;
    }
  }
  return pairs;
}

/** Number of consecutive elements that keep their original order. */
int
KeptNeighbors(const std::vector<int> & order)
{
  const std::size_t size = order.size();
  int               kept = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    kept += order[(i + 1) % size] == static_cast<int>((order[i] + 1) % size) ? 1 : 0;
  }
  return kept;
}

/** Places the largest in the middle and the next ones alternately on both sides. */
std::vector<int>
MiddleOut(const std::vector<int> & sizes)
{
  std::vector<int> bySize(sizes.size());
  std::iota(bySize.begin(), bySize.end(), 0);
  std::stable_sort(bySize.begin(), bySize.end(), [&](int a, int b) { return sizes[a] > sizes[b]; });
  std::deque<int> line;
  for (std::size_t i = 0; i < bySize.size(); ++i)
  {
    i % 2 == 0 ? line.push_front(bySize[i]) : line.push_back(bySize[i]);
  }
  return { line.begin(), line.end() };
}

/** Permutes split components, one pair of nodes after another. The components are the same in all embeddings, and each
 * keeps its half-edges contiguous around both nodes. */
class Arranger
{
public:
  Arranger(const CombinatorialMap & map, const PartedMap & parted)
    : m_Map(map)
    , m_Original(parted.original)
    , m_Parts(parted.parts)
    , m_Next(parted.parts.HalfEdges())
    , m_Previous(parted.parts.HalfEdges())
    , m_SharedFace(parted.parts.Faces(), 0)
    , m_Component(parted.parts.HalfEdges(), -1)
    , m_Seen(map.Nodes(), -1)
  {
    for (int h = 0; h < m_Parts.HalfEdges(); ++h)
    {
      m_Next[h] = m_Parts.NextAround(h);
      m_Previous[h] = m_Parts.PreviousAround(h);
    }
  }

  void
  Arrange(const NodePair & pair)
  {
    const int        number = this->FindComponents(pair);
    std::vector<int> order = MiddleOut(this->SizesOf(pair, number));
    std::vector<int> reversed(order.rbegin(), order.rend());
    const auto       before = this->SidesOf(pair[0], pair[1], number);
    const auto       after = this->SidesOf(pair[1], pair[0], number);
    const auto       rank = [&](const std::vector<int> & o) {
      return std::pair<double, int>(Unevenness(o, before, after), KeptNeighbors(o));
    };
    order = rank(reversed) > rank(order) ? reversed : order;
    this->Relink(pair[0], order);
    std::reverse(order.begin(), order.end()); // reversed around the other node
    this->Relink(pair[1], order);
  }

  /** The rearranged blocks, one after another around the nodes of the given map. */
  CombinatorialMap
  Result() const
  {
    std::vector<std::vector<int>> around(m_Map.Nodes());
    for (int part = 0; part < m_Parts.Nodes(); ++part)
    {
      const int first = m_Parts.FirstAround(part);
      int       h = first;
      do
      {
        around[m_Original[part]].push_back(h);
        h = m_Next[h];
      } while (h != first);
    }
    return { m_Map.ToGraph(), around };
  }

private:
  int
  FindComponents(const NodePair & pair);
  void
  LabelAround(int node, int number, int offset);
  std::vector<int>
  SizesOf(const NodePair & pair, int number);
  std::vector<int>
  SidesOf(int node, int other, int number) const;
  static double
  Unevenness(const std::vector<int> & order, const std::vector<int> & before, const std::vector<int> & after);
  int
  CountFrom(int half, int component);
  void
  Relink(int node, const std::vector<int> & order);

  const CombinatorialMap & m_Map;
  const std::vector<int> & m_Original;
  const CombinatorialMap & m_Parts;
  std::vector<int>         m_Next; ///< successors in the parts, as arranged
  std::vector<int>         m_Previous;
  std::vector<int>         m_SharedFace; ///< 1, 2, ... in their order around the first node of a pair; 0 for others
  std::vector<int>         m_Component;  ///< component of each half-edge around the two nodes
  std::vector<int>         m_Seen;       ///< the last search that visited a node
  int                      m_Searches{ 0 };
};

/** Numbers the components around both nodes in the order of the given map; returns their number. */
int
Arranger::FindComponents(const NodePair & pair)
{
  constexpr int          ofSecond = -1;
  const std::vector<int> opposite = m_Parts.Around(pair[1]);
  int                    number = 0;
  for (const int h : opposite)
  {
    m_SharedFace[m_Parts.Face(h)] = ofSecond;
  }
  for (const int h : m_Parts.Around(pair[0]))
  {
    int & face = m_SharedFace[m_Parts.Face(h)];
    face = face == ofSecond ? ++number : face;
  }
  for (const int h : opposite)
  {
    int & face = m_SharedFace[m_Parts.Face(h)];
    face = std::max(face, 0);
  }
  this->LabelAround(pair[0], number, 0);
  this->LabelAround(pair[1], number, number - 1);
  for (const int h : opposite)
  {
    m_SharedFace[m_Parts.Face(h)] = 0;
  }
  return number;
}

/** Component k is counter-clockwise after shared face k around the first node, before it around the second. */
void
Arranger::LabelAround(int node, int number, int offset)
{
  int first = m_Parts.FirstAround(node);
  while (m_SharedFace[m_Parts.Face(first)] == 0)
  {
    first = m_Parts.NextAround(first);
  }
  int component = 0;
  int h = first;
  do
  {
    const int face = m_SharedFace[m_Parts.Face(h)];
    component = face > 0 ? (face + offset) % number : component;
    h = m_Parts.NextAround(h);
    m_Component[h] = component;
  } while (h != first);
}

/** Number of nodes within each component, including everything connected to it; 0 for an edge. */
std::vector<int>
Arranger::SizesOf(const NodePair & pair, int number)
{
  std::vector<int> sizes(number, 0);
  const int        search = m_Searches++;
  for (const int node : pair)
  {
    m_Seen[m_Original[node]] = search;
  }
  for (const int node : pair)
  {
    for (const int h : m_Parts.Around(node))
    {
      sizes[m_Component[h]] += this->CountFrom(h, search);
    }
  }
  return sizes;
}

/** Counts the nodes beyond a half-edge that this search has not visited. */
int
Arranger::CountFrom(int half, int search)
{
  std::vector<int> found;
  const auto       meet = [&](int h) {
    const int node = m_Map.Node(CombinatorialMap::Twin(h));
    if (m_Seen[node] != search)
    {
      m_Seen[node] = search;
      found.push_back(node);
    }
  };
  meet(half);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const int first = m_Map.FirstAround(found[i]);
    int       h = first;
    do
    {
      meet(h);
      h = m_Map.NextAround(h);
    } while (h != first);
  }
  return static_cast<int>(found.size());
}

/** For each component: half-edges along its last side around `node`, counter-clockwise, to the other node. */
std::vector<int>
Arranger::SidesOf(int node, int other, int number) const
{
  std::vector<int> sides(number, 0);
  for (const int h : m_Parts.Around(node))
  {
    if (m_Component[h] != m_Component[m_Next[h]])
    {
      int & side = sides[m_Component[h]];
      int   along = h;
      for (side = 1; m_Parts.Node(CombinatorialMap::Twin(along)) != other; ++side)
      {
        along = m_Previous[CombinatorialMap::Twin(along)];
      }
    }
  }
  return sides;
}

/** Sum of the squared lengths of the faces between the components. One long face is better than many nested ones, as in
 * a ladder with rungs on different sides. */
double
Arranger::Unevenness(const std::vector<int> & order, const std::vector<int> & before, const std::vector<int> & after)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const double length = before[order[i]] + after[order[(i + 1) % order.size()]];
    sum += length * length;
  }
  return sum;
}

void
Arranger::Relink(int node, const std::vector<int> & order)
{
  int first = m_Parts.FirstAround(node);
  while (m_Component[first] == m_Component[m_Next[first]])
  {
    first = m_Next[first];
  }
  std::vector<std::vector<int>> ofComponent(order.size());
  int                           h = first;
  do
  {
    h = m_Next[h];
    ofComponent[m_Component[h]].push_back(h);
  } while (h != first);
  int last = ofComponent[order.back()].back();
  for (const int component : order)
  {
    for (const int next : ofComponent[component])
    {
      m_Next[last] = next;
      m_Previous[next] = last;
      last = next;
    }
  }
}
} // namespace

CombinatorialMap
ArrangeSplitComponents(const CombinatorialMap & map)
{
  const PartedMap             parted(map);
  const std::vector<NodePair> pairs = SplitPairs(parted.parts);
  if (pairs.empty())
  {
    return map;
  }
  Arranger arranger(map, parted);
  for (const NodePair & pair : pairs)
  {
    arranger.Arrange(pair);
  }
  return arranger.Result();
}
} // namespace shapeton
