#include "shapetonChecks.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace shapeton
{
namespace
{
/** Incidence graph of nodes and faces: neighbors of nodes 0 ... n - 1 and of faces n ... */
class Incidence
{
public:
  explicit Incidence(const TracedMap & map)
    : m_Start(map.nodes + map.firstOfFace.size() + 1, 0), m_List(2 * map.HalfEdges())
  {
    for (int h = 0; h < map.HalfEdges(); ++h)
    {
      ++m_Start[map.node[h] + 1];
      ++m_Start[map.nodes + map.face[h] + 1];
    }
    std::partial_sum(m_Start.begin(), m_Start.end(), m_Start.begin());
    std::vector<int> place(m_Start.begin(), m_Start.end() - 1);
    for (int h = 0; h < map.HalfEdges(); ++h)
    {
      m_List[place[map.node[h]]++] = map.nodes + map.face[h];
      m_List[place[map.nodes + map.face[h]]++] = map.node[h];
    }
  }

  int
  Size() const
  {
    return static_cast<int>(m_Start.size()) - 1;
  }
  int
  Degree(int point) const
  {
    return m_Start[point + 1] - m_Start[point];
  }
  const int *
  Begin(int point) const
  {
    return m_List.data() + m_Start[point];
  }
  const int *
  End(int point) const
  {
    return m_List.data() + m_Start[point + 1];
  }

private:
  std::vector<int> m_Start;
  std::vector<int> m_List;
};

std::string
NameOfPoint(const TracedMap & map, int point)
{
  return point < map.nodes ? "node " + std::to_string(point) : "face " + std::to_string(point - map.nodes);
}

[[noreturn]] void
RefuseFourCycle(const TracedMap & map, int first, int second)
{
  throw Refusal("the packed map is not 3-connected: " + NameOfPoint(map, first) + " and " + NameOfPoint(map, second) +
                " meet more than once, so there is no circle pattern and the solution is degenerate");
}

/** Paths of length two from one point: count per end point, and middle points of the last two paths. */
struct TwoPaths
{
  explicit TwoPaths(int points) : number(points, 0), middles(points) {}

  void
  Add(int middle, int to)
  {
    if (number[to]++ == 0)
    {
      reached.push_back(to);
    }
    middles[to] = { middles[to][1], middle };
  }

  void
  Clear()
  {
    for (const int to : reached)
    {
      number[to] = 0;
    }
    reached.clear();
  }

  std::vector<int>                number;
  std::vector<std::array<int, 2>> middles;
  std::vector<int>                reached;
};

/** True if an edge joins the two points (an edge between nodes, or a dual edge between faces) and has these two points
 * on its sides. */
bool
AreBesideAnEdge(const TracedMap & map, int from, int to, const std::array<int, 2> & middles)
{
  const bool isNode = to < map.nodes;
  const int  first = isNode ? map.firstOfNode[to] : map.firstOfFace[to - map.nodes];
  int        h = first;
  do
  {
    const int other = isNode ? map.node[h ^ 1] : map.nodes + map.face[h ^ 1];
    const int left = isNode ? map.nodes + map.face[h] : map.node[h];
    const int right = isNode ? map.nodes + map.face[h ^ 1] : map.node[h ^ 1];
    if (other == from && ((left == middles[0] && right == middles[1]) || (left == middles[1] && right == middles[0])))
    {
      return true;
    }
    h = isNode ? map.next[h] : map.FaceNext(h);
  } while (h != first);
  return false;
}
} // namespace

/* On the sphere two nodes share exactly two faces if and only if an edge joins them, and these are the faces of the
 * edge; the same holds for two faces. All 4-cycles of the incidence graph are found as pairs of paths of length two
 * from their first point, taken in order of decreasing degree, with earlier points removed (Chiba and Nishizeki 1985):
 * linear on a planar map. */
void
CheckPackingExists(const TracedMap & packed)
{
  if (packed.nodes < 4)
  {
    throw Refusal("the packed map has " + std::to_string(packed.nodes) +
                  " nodes; a circle pattern on the sphere requires four");
  }
  const Incidence  incidence(packed);
  std::vector<int> order(incidence.Size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return incidence.Degree(a) > incidence.Degree(b); });
  std::vector<bool> isDone(order.size(), false);
  std::vector<int>  lastNeighbor(order.size(), -1);
  TwoPaths          paths(incidence.Size());
  for (const int from : order)
  {
    for (const int * middle = incidence.Begin(from); middle != incidence.End(from); ++middle)
    {
      if (std::exchange(lastNeighbor[*middle], from) == from) // a face that meets a node twice
      {
        RefuseFourCycle(packed, from, *middle);
      }
      for (const int * to = incidence.Begin(*middle); !isDone[*middle] && to != incidence.End(*middle); ++to)
      {
        if (*to != from && !isDone[*to])
        {
          paths.Add(*middle, *to);
        }
      }
    }
    for (const int to : paths.reached)
    {
      const bool isSound =
        paths.number[to] == 1 || (paths.number[to] == 2 && AreBesideAnEdge(packed, from, to, paths.middles[to]));
      if (!isSound)
      {
        RefuseFourCycle(packed, from, to);
      }
    }
    paths.Clear();
    isDone[from] = true;
  }
}
} // namespace shapeton
