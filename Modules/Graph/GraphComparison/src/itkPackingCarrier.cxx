#include "itkPackingCarrier.h"

#include "itkCarriedRotation.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace itk
{
PackingCarrier::PackingCarrier(const Graph &            before,
                               const PackedMap &        packed,
                               const Graph &            after,
                               const CombinatorialMap & map)
  : m_Old(packed.map)
  , m_OldNodes(packed.graphNodes)
  , m_After(after)
  , m_Map(map)
  , m_NodeOf(NodesOfSameName(before, after))
  , m_HalfEdgeOf(packed.map.HalfEdges(), -1)
  , m_OldHalfEdge(map.HalfEdges(), -1)
  , m_OldNode(after.nodes, -1)
  , m_StretchOf(map.HalfEdges(), -1)
  , m_LoneStretch(after.nodes, -1)
  , m_Region(packed.map.Nodes(), -1)
  , m_IsGone(packed.map.Nodes(), 0)
  , m_Graph{ after.nodes, after.edges, {} }
{
  this->MatchHalfEdges(before);
  this->FindRegions();
  this->FindStretches();
  this->PlaceAddedEdges();
  this->NumberDummies();
}

void
PackingCarrier::MatchHalfEdges(const Graph & before)
{
  const std::vector<int> edgeOf = EdgesOfSameEnds(before, m_After, m_NodeOf);
  for (std::size_t e = 0; e < edgeOf.size(); ++e)
  {
    if (edgeOf[e] >= 0)
    {
      const int old = static_cast<int>(2 * e);
      const int turned = m_After.edges[edgeOf[e]][0] == m_NodeOf[before.edges[e][0]] ? 0 : 1;
      for (int end = 0; end < 2; ++end)
      {
        m_HalfEdgeOf[old + end] = 2 * edgeOf[e] + (end + turned) % 2;
        m_OldHalfEdge[m_HalfEdgeOf[old + end]] = old + end;
      }
    }
  }
  for (int v = 0; v < m_OldNodes; ++v)
  {
    if (m_NodeOf[v] >= 0)
    {
      m_OldNode[m_NodeOf[v]] = v;
    }
  }
}

/** The dummies of one face hang together, those of two faces do not. */
void
PackingCarrier::FindRegions()
{
  for (int start = m_OldNodes; start < m_Old.Nodes(); ++start)
  {
    std::vector<int> found;
    if (m_Region[start] < 0)
    {
      m_Region[start] = start;
      found.push_back(start);
    }
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      for (const int h : m_Old.Around(found[i]))
      {
        const int head = this->OldHead(h);
        if (this->IsDummy(head) && m_Region[head] < 0)
        {
          m_Region[head] = start;
          found.push_back(head);
        }
      }
    }
  }
}

void
PackingCarrier::FindStretches()
{
  for (int node = 0; node < m_After.nodes; ++node)
  {
    bool hasOld = false;
    for (const int h : m_Map.Around(node))
    {
      if (m_OldHalfEdge[h] >= 0)
      {
        hasOld = true;
        m_StretchOf[h] = this->AddStretch(h, m_OldHalfEdge[h], node);
      }
    }
    if (!hasOld && m_OldNode[node] >= 0)
    {
      this->AddLoneNode(node);
    }
  }
}

/** A node without an edge that both steps have stays among its dummies while it has no edges at all; else it comes to
 * its new neighbours, not they to it. */
void
PackingCarrier::AddLoneNode(int node)
{
  if (m_Map.FirstAround(node) < 0)
  {
    m_LoneStretch[node] = this->AddStretch(-1, -1, node);
    return;
  }
  m_NodeOf[m_OldNode[node]] = -1;
  m_OldNode[node] = -1;
}

/** Walks from a half-edge that both steps have, or where that is -1 from any, to the next one in both maps. Returns the
 * number of the stretch; -1 for an empty one. */
int
PackingCarrier::AddStretch(int start, int oldStart, int node)
{
  Stretch   stretch;
  const int oldFirst = start < 0 ? m_Old.FirstAround(m_OldNode[node]) : m_Old.NextAround(oldStart);
  const int first = start < 0 ? m_Map.FirstAround(node) : m_Map.NextAround(start);
  int       oldEnd = oldFirst;
  int       end = first;
  for (bool isBegun = false; oldEnd >= 0 && m_HalfEdgeOf[oldEnd] < 0 && !(isBegun && oldEnd == oldFirst);
       oldEnd = m_Old.NextAround(oldEnd), isBegun = true)
  {
    if (this->IsDummy(this->OldHead(oldEnd)))
    {
      stretch.dummies.push_back(oldEnd);
    }
  }
  for (bool isBegun = false; end >= 0 && m_OldHalfEdge[end] < 0 && !(isBegun && end == first);
       end = m_Map.NextAround(end), isBegun = true)
  {
    stretch.added.push_back(end);
    m_StretchOf[end] = static_cast<int>(m_Stretches.size());
  }
  if (start >= 0 && m_OldHalfEdge[end] != oldEnd)
  {
    this->DropRegionsOf(stretch);
  }
  if (stretch.dummies.empty() && stretch.added.empty())
  {
    return -1;
  }
  m_Stretches.push_back(std::move(stretch));
  return static_cast<int>(m_Stretches.size()) - 1;
}

void
PackingCarrier::DropRegionsOf(const Stretch & stretch)
{
  for (const int h : stretch.dummies)
  {
    m_IsGone[m_Region[this->OldHead(h)]] = 1;
  }
}

bool
PackingCarrier::HasDummies(int stretch) const
{
  return stretch >= 0 && std::any_of(m_Stretches[stretch].dummies.begin(),
                                     m_Stretches[stretch].dummies.end(),
                                     [this](int h) { return this->Stays(this->OldHead(h)); });
}

/** Where dummies cannot make room one by one, all of the face go. */
void
PackingCarrier::PlaceAddedEdges()
{
  for (int h = 0; h < m_Map.HalfEdges(); h += 2)
  {
    const std::array<int, 2> stretches{ m_StretchOf[h], m_StretchOf[h + 1] };
    const bool               hasDummies = this->HasDummies(stretches[0]) || this->HasDummies(stretches[1]);
    if (m_OldHalfEdge[h] >= 0 || !hasDummies || this->MakeRoom(h))
    {
      continue;
    }
    for (const int stretch : stretches)
    {
      stretch >= 0 ? this->DropRegionsOf(m_Stretches[stretch]) : void();
    }
  }
}

/** For an edge. False when dummies are in the way that cannot make room. */
bool
PackingCarrier::MakeRoom(int halfEdge)
{
  for (const int h : { halfEdge, CombinatorialMap::Twin(halfEdge) })
  {
    const int  twin = CombinatorialMap::Twin(h);
    const bool isLeaf = m_StretchOf[twin] < 0 && m_Map.NextAround(twin) == twin;
    if (isLeaf)
    {
      return this->MakeRoomForLeaf(m_Stretches[m_StretchOf[h]]);
    }
  }
  return m_StretchOf[halfEdge] >= 0 && m_StretchOf[CombinatorialMap::Twin(halfEdge)] >= 0 &&
         this->MakeRoomBetween(m_Stretches[m_StretchOf[halfEdge]],
                               m_Stretches[m_StretchOf[CombinatorialMap::Twin(halfEdge)]]);
}

/** In the middle of the dummies of a stretch. */
bool
PackingCarrier::MakeRoomForLeaf(Stretch & stretch)
{
  const int middle = static_cast<int>(stretch.dummies.size() / 2);
  if (stretch.added.size() != 1 || !this->Stays(this->OldHead(stretch.dummies[middle])))
  {
    return false;
  }
  stretch.place = middle;
  m_IsGone[this->OldHead(stretch.dummies[middle])] = 1;
  return true;
}

/** Takes out the dummies between the two ends of an edge. False when there is no way, or when one end has several new
 * edges. */
bool
PackingCarrier::MakeRoomBetween(Stretch & from, Stretch & to)
{
  if (from.added.size() != 1 || to.added.size() != 1)
  {
    return false;
  }
  const std::vector<int> path = this->ShortestPath(from, to);
  if (path.empty())
  {
    return false;
  }
  const auto placeOf = [this](const Stretch & stretch, int dummy) {
    const auto isIt = [this, dummy](int h) { return this->OldHead(h) == dummy; };
    return static_cast<int>(std::find_if(stretch.dummies.begin(), stretch.dummies.end(), isIt) -
                            stretch.dummies.begin());
  };
  from.place = placeOf(from, path.front());
  to.place = placeOf(to, path.back());
  for (const int dummy : path)
  {
    m_IsGone[dummy] = 1;
  }
  return true;
}

/** Of dummies, each one beside the next; empty when there is none. */
std::vector<int>
PackingCarrier::ShortestPath(const Stretch & from, const Stretch & to) const
{
  std::unordered_map<int, int> before;
  std::vector<int>             queue;
  const auto                   meet = [&](int dummy, int last) {
    if (this->IsDummy(dummy) && this->Stays(dummy) && before.emplace(dummy, last).second)
    {
      queue.push_back(dummy);
    }
  };
  for (const int h : from.dummies)
  {
    meet(this->OldHead(h), -1);
  }
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    const int node = queue[i];
    if (std::any_of(to.dummies.begin(), to.dummies.end(), [&](int h) { return this->OldHead(h) == node; }))
    {
      std::vector<int> path;
      for (int dummy = node; dummy >= 0; dummy = before[dummy])
      {
        path.insert(path.begin(), dummy);
      }
      return path;
    }
    for (const int h : m_Old.Around(node))
    {
      meet(this->OldHead(h), node);
    }
  }
  return {};
}
} // namespace itk
