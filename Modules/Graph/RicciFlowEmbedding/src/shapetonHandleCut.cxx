#include "shapetonHandleCut.h"

#include "shapetonDisjointSets.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** Maximum number of steps in the search for the shortest curve of one handle. */
constexpr long mostVisits = 10'000'000;

/** Faces of a component by distance from one of them, breadth first. */
struct DualTree
{
  DualTree(const CombinatorialMap & map, int root)
    : depth(map.Faces(), -1), arrival(map.Faces(), -1), isCrossed(map.Edges(), 0)
  {
    std::vector<int> queue{ root };
    depth[root] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      const int first = map.FirstOfFace(queue[i]);
      int       h = first;
      do
      {
        const int beyond = map.Face(CombinatorialMap::Twin(h));
        if (depth[beyond] < 0)
        {
          depth[beyond] = depth[queue[i]] + 1;
          arrival[beyond] = h;
          isCrossed[h / 2] = 1;
          queue.push_back(beyond);
        }
        h = map.FaceNext(h);
      } while (h != first);
    }
  }

  std::vector<int>  depth;   ///< -1 in other components
  std::vector<int>  arrival; ///< the half-edge crossed from left to right to reach the face; -1 for the root
  std::vector<char> isCrossed;
};

/** The edge in neither tree with the shortest loop, or -1; edges with long loops join the cotree first. */
int
EdgeOfShortestLoop(const CombinatorialMap & map, const DualTree & tree)
{
  const auto lengthOf = [&](int edge) { return tree.depth[map.Face(2 * edge)] + tree.depth[map.Face(2 * edge + 1)]; };
  std::vector<int> edges;
  for (int edge = 0; edge < map.Edges(); ++edge)
  {
    if (tree.depth[map.Face(2 * edge)] >= 0 && !tree.isCrossed[edge])
    {
      edges.push_back(edge);
    }
  }
  std::stable_sort(edges.begin(), edges.end(), [&](int a, int b) { return lengthOf(a) > lengthOf(b); });
  DisjointSets sets(map.Nodes());
  int          last = -1;
  for (const int edge : edges)
  {
    last = sets.Join(map.Node(2 * edge), map.Node(2 * edge + 1)) ? last : edge;
  }
  return last;
}

/** Half-edges crossed by a loop from left to right. */
std::vector<int>
LoopThrough(const CombinatorialMap & map, const DualTree & tree, int edge)
{
  std::vector<int> there; // from the face to the left of the edge toward the root
  std::vector<int> back;
  int              left = map.Face(2 * edge);
  int              right = map.Face(2 * edge + 1);
  while (left != right)
  {
    const bool isLeft = tree.depth[left] >= tree.depth[right];
    int &      face = isLeft ? left : right;
    isLeft ? there.push_back(tree.arrival[face]) : back.push_back(CombinatorialMap::Twin(tree.arrival[face]));
    face = map.Face(tree.arrival[face]);
  }
  std::reverse(there.begin(), there.end());
  there.push_back(2 * edge);
  there.insert(there.end(), back.begin(), back.end());
  return there;
}

/** Shortest loop found from some root faces; empty for genus 0. */
std::vector<int>
ShortestHandleCurve(const CombinatorialMap & map)
{
  std::vector<char> isTried(map.Faces(), 0);
  std::vector<int>  best;
  const auto        tryRoot = [&](int root) {
    isTried[root] = 1;
    const DualTree tree(map, root);
    const int      edge = EdgeOfShortestLoop(map, tree);
    if (edge >= 0)
    {
      const std::vector<int> loop = LoopThrough(map, tree, edge);
      if (best.empty() || loop.size() < best.size())
      {
        best = loop;
      }
    }
  };
  const long stride = 1 + static_cast<long>(map.Faces()) * map.HalfEdges() / mostVisits;
  for (long face = 0; face < map.Faces(); face += stride)
  {
    tryRoot(static_cast<int>(face));
  }
  // The stride may have skipped a component with handles.
  for (int face = 0; best.empty() && face < map.Faces(); ++face)
  {
    const int component = map.ComponentOfNode()[map.Node(map.FirstOfFace(face))];
    if (!isTried[face] && map.GenusOfComponent()[component] > 0)
    {
      tryRoot(face);
    }
  }
  return best;
}

/** A map under construction. */
class Cutter
{
public:
  Cutter(const CombinatorialMap & map, std::vector<int> across)
    : m_Nodes(map.Nodes()), m_Edges(map.ToGraph().edges), m_Next(map.HalfEdges()), m_Across(std::move(across))
  {
    m_Previous.resize(m_Next.size());
    for (int h = 0; h < map.HalfEdges(); ++h)
    {
      m_Next[h] = map.NextAround(h);
      m_Previous[h] = map.PreviousAround(h);
    }
  }

  /** Cuts along a curve that crosses these half-edges from left to right; returns the hubs of its right and left bank.
   */
  std::array<int, 2>
  Cut(const std::vector<int> & curve)
  {
    const std::array<int, 2> hubs{ m_Nodes, m_Nodes + 1 };
    std::vector<int>         right;
    std::vector<int>         left;
    m_Nodes += 2;
    for (const int h : curve)
    {
      const int end = (h & ~1) + 1;
      const int start = this->SplitEdge(h / 2);
      // The start of h is on the right bank.
      const bool isStartOnRight = h % 2 == 0;
      right.push_back(isStartOnRight ? end : start);
      left.push_back(isStartOnRight ? start : end);
      m_Edges[end / 2][1] = hubs[isStartOnRight ? 0 : 1];
      m_Edges[start / 2][0] = hubs[isStartOnRight ? 1 : 0];
    }
    std::reverse(left.begin(), left.end());
    this->SetOrder(right);
    this->SetOrder(left);
    return hubs;
  }
  CombinatorialMap
  Map() const
  {
    return { m_Nodes, m_Edges, m_Next };
  }
  const std::vector<int> &
  Across() const
  {
    return m_Across;
  }

private:
  /** Keeps half-edge 2e; a new edge replaces 2e + 1 at the end node. Returns its first half-edge, which continues where
   * 2e + 1 ends. */
  int
  SplitEdge(int edge)
  {
    const int start = static_cast<int>(m_Next.size());
    const int end = start + 1;
    const int old = 2 * edge + 1;
    m_Edges.push_back({ -1, m_Edges[edge][1] });
    const bool isAlone = m_Next[old] == old;
    m_Next.insert(m_Next.end(), { start, isAlone ? end : m_Next[old] });
    m_Previous.insert(m_Previous.end(), { start, isAlone ? end : m_Previous[old] });
    m_Next[m_Previous[end]] = end;
    m_Previous[m_Next[end]] = end;
    m_Across.insert(m_Across.end(), { old, m_Across[old] });
    if (m_Across[old] >= 0)
    {
      m_Across[m_Across[old]] = end;
    }
    m_Across[old] = start;
    return start;
  }
  void
  SetOrder(const std::vector<int> & around)
  {
    for (std::size_t i = 0; i < around.size(); ++i)
    {
      const int next = around[(i + 1) % around.size()];
      m_Next[around[i]] = next;
      m_Previous[next] = around[i];
    }
  }

  int                             m_Nodes;
  std::vector<std::array<int, 2>> m_Edges;
  std::vector<int>                m_Next;
  std::vector<int>                m_Previous;
  std::vector<int>                m_Across;
};
} // namespace

HandleCut::HandleCut(const CombinatorialMap & map) : sphere(map), across(map.HalfEdges(), -1)
{
  for (int handles = map.Genus(); handles > 0; --handles)
  {
    Cutter cutter(sphere, across);
    hubs.push_back(cutter.Cut(ShortestHandleCurve(sphere)));
    sphere = cutter.Map();
    across = cutter.Across();
  }
}
} // namespace shapeton
