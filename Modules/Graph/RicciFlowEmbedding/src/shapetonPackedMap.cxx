#include "shapetonPackedMap.h"

#include "shapetonGraphStructure.h"
#include "shapetonMapBuilder.h"
#include "shapetonExceptions.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** Rings with at most this many nodes are closed by a single dummy. */
constexpr std::size_t largestStar = 6;

/** Loops, and edges parallel to one with a lower number. */
struct BadEdges
{
  explicit BadEdges(const CombinatorialMap & map)
  {
    const std::vector<int> first = FirstParallels(map.ToGraph());
    for (int e = 0; e < map.Edges(); ++e)
    {
      if (first[e] < 0)
      {
        loops.push_back(e);
      }
      else if (first[e] != e)
      {
        parallel.push_back(e);
      }
    }
  }
  std::vector<int> loops;
  std::vector<int> parallel;
};

/** The longest face of each component, by its lowest half-edge; -1 for a node without edges. */
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

/** Parts of a boundary, one for each dummy of a ring: the index of the first half-edge of each part, ascending. */
using RingParts = std::vector<int>;

RingParts
EvenParts(std::size_t length, std::size_t covered)
{
  RingParts parts;
  for (std::size_t i = 0; i < length; i += covered)
  {
    parts.push_back(static_cast<int>(i));
  }
  return parts;
}

/** Rotates a boundary that visits leaves so that it starts at a leaf; otherwise unchanged. */
void
BeginAtLeaf(std::vector<int> & boundary)
{
  for (std::size_t i = 0; i < boundary.size(); ++i)
  {
    if (boundary[i] == CombinatorialMap::Twin(boundary[(i + boundary.size() - 1) % boundary.size()]))
    {
      std::rotate(boundary.begin(), boundary.begin() + i, boundary.end());
      return;
    }
  }
}

/** Parts of at most `covered` half-edges, none of which meets a node twice. Using few dummies keeps the node circles
 * large. */
RingParts
SimpleParts(const MapBuilder & builder, const std::vector<int> & boundary, int covered)
{
  const int        length = static_cast<int>(boundary.size());
  RingParts        parts;
  std::vector<int> nodes; // nodes of the part, including its end
  for (int i = 0; i < length; ++i)
  {
    const int end = builder.Node(boundary[(i + 1) % length]);
    if (parts.empty() || i - parts.back() == covered || std::find(nodes.begin(), nodes.end(), end) != nodes.end())
    {
      parts.push_back(i);
      nodes.assign(1, builder.Node(boundary[i]));
    }
    nodes.push_back(end);
  }
  return parts.size() < 3 ? EvenParts(length, 1) : parts;
}

/** Adds dummies for a face with the half-edges `boundary`: each is joined to all nodes of its part, and to the dummies
 * before and after it. Returns the boundary of the remaining face. */
std::vector<int>
AddRing(MapBuilder & builder, const std::vector<int> & boundary, const RingParts & parts)
{
  const int                     length = static_cast<int>(boundary.size());
  const int                     number = static_cast<int>(parts.size());
  const int                     first = builder.Nodes();
  std::vector<std::vector<int>> around(number);
  std::vector<int>              last(boundary); // at each corner, the half-edge to insert after
  std::vector<int>              ring(number);
  for (int j = 0; j < number; ++j)
  {
    builder.AddNode();
  }
  const auto endOf = [&](int j) { return j + 1 < number ? parts[j + 1] : length; };
  // At a corner between two dummies, the half-edge of the later one is first in counter-clockwise order.
  for (int j = 0; j < number; ++j)
  {
    const int begin = parts[j];
    for (int i = begin; i <= endOf(j); ++i)
    {
      around[j].push_back(builder.AddEdge(first + j, builder.Node(boundary[i % length])));
    }
    for (int i = begin; i < endOf(j); ++i)
    {
      builder.InsertAfter(last[i], around[j][i - begin] + 1);
      last[i] = i == begin ? around[j][0] + 1 : last[i];
    }
  }
  for (int j = 0; j < number; ++j)
  {
    builder.InsertAfter(last[endOf(j) % length], around[j].back() + 1);
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
  const int        center = builder.AddNode();
  std::vector<int> around;
  for (const int h : boundary)
  {
    around.push_back(builder.AddEdge(center, builder.Node(h)));
    builder.InsertAfter(h, around.back() + 1);
  }
  builder.SetAround(around);
}

/** K1 and K2 become K4; each of the two faces of a triangle gets a node. */
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

/** Faces that are not triangles and are in conflict, or long. */
std::vector<int>
FacesToFill(const CombinatorialMap & map, const FaceConflicts & conflicts, int longestFace)
{
  const std::vector<int> lengths = map.FaceLengths();
  std::vector<int>       faces;
  for (int face = 0; face < map.Faces(); ++face)
  {
    if (lengths[face] > longestFace ||
        (lengths[face] != 3 && (conflicts.meetsANodeTwice[face] || conflicts.sharesTwoNodes[face])))
    {
      faces.push_back(face);
    }
  }
  return faces;
}

CombinatorialMap
FillFaces(const CombinatorialMap & map, const AugmentationOptions & options, int & rings)
{
  const FaceConflicts    conflicts(map);
  const std::vector<int> faces = FacesToFill(map, conflicts, options.longestFace);
  if (faces.empty())
  {
    return map;
  }
  MapBuilder builder(map);
  for (const int face : faces)
  {
    std::vector<int> boundary = map.Boundary(face);
    if (conflicts.meetsANodeTwice[face])
    {
      ++rings;
      BeginAtLeaf(boundary);
      boundary = AddRing(builder, boundary, SimpleParts(builder, boundary, options.halfEdgesOfDummy));
    }
    while (boundary.size() > largestStar)
    {
      boundary = AddRing(builder, boundary, EvenParts(boundary.size(), 2));
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
      "without dummy nodes this map has no circle packing, only a degenerate limit, even if the residual "
      "is small: " +
      reason + "; use the parameter \"augmentation\" = ring");
  }
}
} // namespace

PackedMap
MakePackedMap(const CombinatorialMap & map, const AugmentationOptions & options)
{
  PackedMap packed;
  packed.graphNodes = map.Nodes();
  packed.graphEdges = map.Edges();
  if (map.Nodes() == 0)
  {
    throw InputError("a graph without nodes cannot be embedded");
  }
  if (options.augmentation == Augmentation::None)
  {
    RequirePackable(map, options.names);
    packed.map = map;
    return packed;
  }
  packed.map = DivideBadEdges(JoinComponents(map), packed.subdivided);
  const bool isTriangle = packed.map.Nodes() == 3 && packed.map.Edges() == 3;
  packed.map =
    packed.map.Nodes() <= 2 || isTriangle ? FillSmallMap(packed.map) : FillFaces(packed.map, options, packed.rings);
  return packed;
}
} // namespace shapeton
