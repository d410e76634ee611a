#include "itkPackedMap.h"

#include "itkMapBuilder.h"
#include "itkToolError.h"

#include <algorithm>
#include <numeric>

namespace itk
{
namespace
{
/** A ring of this many or fewer is closed by one dummy. */
constexpr std::size_t largestStar = 6;

/** Loops, and edges that are parallel to one of a smaller number. */
struct BadEdges
{
  explicit BadEdges(const CombinatorialMap & map)
  {
    std::vector<int>                order(map.Edges());
    std::vector<std::array<int, 2>> ends(map.Edges());
    for (int e = 0; e < map.Edges(); ++e)
    {
      ends[e] = { std::min(map.Node(2 * e), map.Node(2 * e + 1)), std::max(map.Node(2 * e), map.Node(2 * e + 1)) };
    }
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return ends[a] < ends[b]; });
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      if (ends[order[i]][0] == ends[order[i]][1])
      {
        loops.push_back(order[i]);
      }
      else if (i > 0 && ends[order[i]] == ends[order[i - 1]])
      {
        parallel.push_back(order[i]);
      }
    }
    std::sort(loops.begin(), loops.end());
    std::sort(parallel.begin(), parallel.end());
  }
  std::vector<int> loops;
  std::vector<int> parallel;
};

/** The longest face of each component: its smallest half-edge, or -1 for a node without edges. */
std::vector<int>
CornersOfLongestFaces(const CombinatorialMap & map)
{
  const std::vector<int> lengths = map.FaceLengths();
  std::vector<int>       corner(map.Components(), -1);
  for (int face = 0; face < map.Faces(); ++face)
  {
    const int h = map.FirstOfFace(face);
    int &     best = corner[map.ComponentOfNode()[map.Node(h)]];
    if (best < 0 || lengths[face] > lengths[map.Face(best)])
    {
      best = h;
    }
  }
  return corner;
}

CombinatorialMap
JoinComponents(const CombinatorialMap & map)
{
  if (map.Components() <= 1)
  {
    return map;
  }
  const std::vector<int> corner = CornersOfLongestFaces(map);
  MapBuilder             builder(map);
  const int              hub = builder.AddNode();
  std::vector<int>       around;
  std::vector<char>      isJoined(map.Components(), 0);
  for (int node = 0; node < map.Nodes(); ++node)
  {
    const int component = map.ComponentOfNode()[node];
    if (isJoined[component])
    {
      continue;
    }
    isJoined[component] = 1;
    const int h = corner[component];
    around.push_back(builder.AddEdge(hub, h < 0 ? node : map.Node(h)));
    if (h >= 0)
    {
      builder.InsertAfter(h, around.back() + 1);
    }
  }
  builder.SetAround(around);
  return builder.Build();
}

CombinatorialMap
DivideBadEdges(const CombinatorialMap & map, std::vector<std::vector<int>> & subdivided)
{
  const BadEdges bad(map);
  if (bad.loops.empty() && bad.parallel.empty())
  {
    return map;
  }
  MapBuilder builder(map);
  for (const int edge : bad.loops)
  {
    subdivided.push_back(builder.Divide(edge, 3));
  }
  for (const int edge : bad.parallel)
  {
    subdivided.push_back(builder.Divide(edge, 2));
  }
  return builder.Build();
}

/** Dummies for a face whose half-edges are `boundary`: each covers `covered` of them, is joined with all nodes of
 * those, and with the dummies before and after it. Returns the boundary of the face that is left. */
std::vector<int>
AddRing(MapBuilder & builder, const std::vector<int> & boundary, int covered)
{
  const int                     length = static_cast<int>(boundary.size());
  const int                     number = (length + covered - 1) / covered;
  const int                     first = builder.Nodes();
  std::vector<std::vector<int>> around(number);
  std::vector<int>              last(boundary); // at each corner: after it comes what is still to be put there
  std::vector<int>              ring(number);
  for (int j = 0; j < number; ++j)
  {
    builder.AddNode();
  }
  // At a corner between two dummies the later one's half-edge comes first, counter-clockwise.
  for (int j = 0; j < number; ++j)
  {
    const int begin = j * covered;
    const int end = std::min(length, begin + covered);
    for (int i = begin; i <= end; ++i)
    {
      around[j].push_back(builder.AddEdge(first + j, builder.Node(boundary[i % length])));
    }
    for (int i = begin; i < end; ++i)
    {
      builder.InsertAfter(last[i], around[j][i - begin] + 1);
      last[i] = i == begin ? around[j][0] + 1 : last[i];
    }
  }
  for (int j = 0; j < number; ++j)
  {
    const int corner = std::min(length, (j + 1) * covered) % length;
    builder.InsertAfter(last[corner], around[j].back() + 1);
    ring[j] = builder.AddEdge(first + j, first + (j + 1) % number);
  }
  for (int j = 0; j < number; ++j)
  {
    around[j].push_back(ring[j]);
    around[j].push_back(ring[(j + number - 1) % number] + 1);
    builder.SetAround(around[j]);
  }
  return ring;
}

void
AddStar(MapBuilder & builder, const std::vector<int> & boundary)
{
  const int        centre = builder.AddNode();
  std::vector<int> around;
  for (const int h : boundary)
  {
    around.push_back(builder.AddEdge(centre, builder.Node(h)));
    builder.InsertAfter(h, around.back() + 1);
  }
  builder.SetAround(around);
}

/** K1 and K2 become K4; the two faces of a triangle get a node each. */
CombinatorialMap
FillSmallMap(const CombinatorialMap & map)
{
  MapBuilder builder(map);
  if (map.Nodes() == 3)
  {
    AddStar(builder, map.Boundary(0));
    AddStar(builder, map.Boundary(1));
    return builder.Build();
  }
  if (map.Nodes() == 1)
  {
    builder.AddEdge(0, builder.AddNode());
  }
  const int one = builder.Node(0);
  const int other = builder.Node(1);
  const int third = builder.AddNode();
  const int fourth = builder.AddNode();
  const int a = builder.AddEdge(one, third);
  const int b = builder.AddEdge(one, fourth);
  const int c = builder.AddEdge(other, third);
  const int d = builder.AddEdge(other, fourth);
  const int e = builder.AddEdge(third, fourth);
  builder.SetAround({ 0, a, b });
  builder.SetAround({ 1, d, c });
  builder.SetAround({ a + 1, c + 1, e });
  builder.SetAround({ b + 1, e + 1, d + 1 });
  return builder.Build();
}

CombinatorialMap
FillFaces(const CombinatorialMap & map)
{
  const FaceConflicts conflicts(map);
  MapBuilder          builder(map);
  for (int face = 0; face < map.Faces(); ++face)
  {
    std::vector<int> boundary = map.Boundary(face);
    if (boundary.size() == 3 || !(conflicts.meetsANodeTwice[face] || conflicts.sharesTwoNodes[face]))
    {
      continue;
    }
    if (conflicts.meetsANodeTwice[face])
    {
      boundary = AddRing(builder, boundary, 1);
    }
    while (boundary.size() > largestStar)
    {
      boundary = AddRing(builder, boundary, 2);
    }
    if (boundary.size() > 3)
    {
      AddStar(builder, boundary);
    }
  }
  return builder.Build();
}

void
RequirePackable(const CombinatorialMap & map, const std::vector<std::string> & names)
{
  const BadEdges bad(map);
  std::string    reason;
  if (map.Components() != 1)
  {
    reason = "it has " + std::to_string(map.Components()) + " components";
  }
  else if (map.Nodes() < 4)
  {
    reason = "it has fewer than 4 nodes";
  }
  else if (!bad.loops.empty() || !bad.parallel.empty())
  {
    reason = "it has loops or parallel edges";
  }
  else
  {
    reason = FaceConflicts(map, names).reason;
  }
  if (!reason.empty())
  {
    throw InputError(
      "without dummy nodes this map has no circle packing, only a degenerate limit that a small residual "
      "does not show: " +
      reason + "; use --augmentation ring");
  }
}
} // namespace

PackedMap
MakePackedMap(const CombinatorialMap & map, Augmentation augmentation, const std::vector<std::string> & names)
{
  PackedMap packed;
  packed.graphNodes = map.Nodes();
  packed.graphEdges = map.Edges();
  if (map.Nodes() == 0)
  {
    throw InputError("a graph without nodes cannot be embedded");
  }
  if (augmentation == Augmentation::None)
  {
    RequirePackable(map, names);
    packed.map = map;
    return packed;
  }
  packed.map = DivideBadEdges(JoinComponents(map), packed.subdivided);
  const bool isTriangle = packed.map.Nodes() == 3 && packed.map.Edges() == 3;
  packed.map = packed.map.Nodes() <= 2 || isTriangle ? FillSmallMap(packed.map) : FillFaces(packed.map);
  return packed;
}
} // namespace itk
