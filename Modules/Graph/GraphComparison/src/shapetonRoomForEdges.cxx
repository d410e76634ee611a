#include "shapetonRoomForEdges.h"

#include <algorithm>
#include <unordered_map>

namespace shapeton
{
namespace
{
/** If more dummies separate the ends of an edge, making the circles of the ends touch would move them and their
 * surroundings far. */
constexpr std::size_t mostDummiesTakenOut = 1;

/** An end of a new edge: a position in the order around its node. */
struct EdgeEnd
{
  DummyStretch * stretch;
  std::size_t    index; ///< in the list of added half-edges
};

/** The dummies of a stretch that lie between the dummies of adjacent edges; one dummy is reserved for each unplaced
 * edge. */
struct PlacesOfEnd
{
  explicit PlacesOfEnd(const EdgeEnd & end) : end(static_cast<int>(end.stretch->dummies.size()))
  {
    const std::vector<int> & places = end.stretch->places;
    for (std::size_t i = 0; i < end.index; ++i)
    {
      first = places[i] >= 0 ? places[i] + 1 : first + 1;
    }
    for (std::size_t i = places.size() - 1; i > end.index; --i)
    {
      this->end = places[i] >= 0 ? places[i] : this->end - 1;
    }
    this->end = std::max(this->end, 0); // there may be too few
    first = std::min(first, this->end);
  }
  int first{ 0 };
  int end;
};

class RoomForEdges
{
public:
  RoomForEdges(const CombinatorialMap & packed,
               const CombinatorialMap & map,
               DummyStretches &         stretches,
               FaceDummies &            dummies)
    : m_Packed(packed), m_Map(map), m_Stretches(stretches), m_Dummies(dummies)
  {}

  void
  Make(int edge)
  {
    const EdgeEnd from = this->EndOf(2 * edge);
    const EdgeEnd to = this->EndOf(2 * edge + 1);
    if ((!this->HasDummies(from) && !this->HasDummies(to)) || this->MakeBetween(edge, from, to))
    {
      return;
    }
    for (const EdgeEnd & end : { from, to })
    {
      if (end.stretch)
      {
        m_Dummies.DropHeads(end.stretch->dummies);
      }
    }
  }
  std::vector<DummyWay>
  Take()
  {
    return std::move(m_Ways);
  }

private:
  EdgeEnd
  EndOf(int halfEdge)
  {
    DummyStretch * const stretch = m_Stretches.Of(halfEdge);
    const auto           indexOf = [halfEdge](const std::vector<int> & list) {
      return static_cast<std::size_t>(std::find(list.begin(), list.end(), halfEdge) - list.begin());
    };
    return { stretch, stretch ? indexOf(stretch->added) : 0 };
  }
  bool
  HasDummies(const EdgeEnd & end) const
  {
    return end.stretch && std::any_of(end.stretch->dummies.begin(), end.stretch->dummies.end(), [this](int h) {
             return m_Dummies.Stays(m_Dummies.Head(h));
           });
  }
  bool
  IsLeaf(int halfEdge, const EdgeEnd & end) const
  {
    return !end.stretch && m_Map.NextAround(halfEdge) == halfEdge;
  }
  bool
  MakeBetween(int edge, const EdgeEnd & from, const EdgeEnd & to);
  bool
  MakeInTheMiddle(const EdgeEnd & end);
  bool
  MakeAlongWay(int edge, const EdgeEnd & from, const EdgeEnd & to);
  std::vector<int>
  ShortestWay(const EdgeEnd & from, const EdgeEnd & to) const;
  int
  PlaceOf(const EdgeEnd & end, int dummy) const;

  const CombinatorialMap & m_Packed;
  const CombinatorialMap & m_Map;
  DummyStretches &         m_Stretches;
  FaceDummies &            m_Dummies;
  std::vector<DummyWay>    m_Ways;
};

/** Returns false if dummies that cannot be removed block the way. */
bool
RoomForEdges::MakeBetween(int edge, const EdgeEnd & from, const EdgeEnd & to)
{
  if (this->IsLeaf(2 * edge + 1, to))
  {
    return this->MakeInTheMiddle(from);
  }
  if (this->IsLeaf(2 * edge, from))
  {
    return this->MakeInTheMiddle(to);
  }
  return from.stretch && to.stretch && this->MakeAlongWay(edge, from, to);
}

/** Handles an edge to a leaf. */
bool
RoomForEdges::MakeInTheMiddle(const EdgeEnd & end)
{
  const PlacesOfEnd places(end);
  const int         middle = (places.first + places.end) / 2;
  if (middle >= places.end || !m_Dummies.IsFree(m_Dummies.Head(end.stretch->dummies[middle])))
  {
    return false;
  }
  end.stretch->places[end.index] = middle;
  m_Dummies.Drop(m_Dummies.Head(end.stretch->dummies[middle]));
  return true;
}

/** Position of a dummy at an end of a new edge, or -1. */
int
RoomForEdges::PlaceOf(const EdgeEnd & end, int dummy) const
{
  const PlacesOfEnd places(end);
  for (int place = places.first; place < places.end; ++place)
  {
    if (m_Dummies.Head(end.stretch->dummies[place]) == dummy)
    {
      return place;
    }
  }
  return -1;
}

/** Returns false if no path exists. */
bool
RoomForEdges::MakeAlongWay(int edge, const EdgeEnd & from, const EdgeEnd & to)
{
  std::vector<int> way = this->ShortestWay(from, to);
  if (way.empty())
  {
    return false;
  }
  const bool stays = way.size() > mostDummiesTakenOut;
  for (const int h : way)
  {
    const int dummy = m_Dummies.Head(h);
    stays ? m_Dummies.Take(dummy) : m_Dummies.Drop(dummy);
  }
  int & first = from.stretch->places[from.index];
  int & last = to.stretch->places[to.index];
  first = this->PlaceOf(from, m_Dummies.Head(way.front()));
  last = this->PlaceOf(to, m_Dummies.Head(way.back()));
  if (stays)
  {
    way.push_back(CombinatorialMap::Twin(to.stretch->dummies[last]));
    m_Ways.push_back({ edge, std::move(way) });
  }
  return true;
}

/** Shortest path in the old packed map through free dummies, from one end of an edge to a neighbor of the other end, as
 * half-edges; empty if there is none. */
std::vector<int>
RoomForEdges::ShortestWay(const EdgeEnd & from, const EdgeEnd & to) const
{
  std::unordered_map<int, int> arrival; // at each visited dummy
  std::vector<int>             queue;
  const auto                   meet = [&](int h) {
    const int node = m_Dummies.Head(h);
    if (m_Dummies.IsDummy(node) && m_Dummies.IsFree(node) && arrival.emplace(node, h).second)
    {
      queue.push_back(node);
    }
  };
  const PlacesOfEnd places(from);
  std::for_each(from.stretch->dummies.begin() + places.first, from.stretch->dummies.begin() + places.end, meet);
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    if (this->PlaceOf(to, queue[i]) >= 0)
    {
      std::vector<int> way;
      for (int node = queue[i]; m_Dummies.IsDummy(node); node = m_Packed.Node(way.back()))
      {
        way.push_back(arrival[node]);
      }
      std::reverse(way.begin(), way.end());
      return way;
    }
    const std::vector<int> around = m_Packed.Around(queue[i]);
    std::for_each(around.begin(), around.end(), meet);
  }
  return {};
}
} // namespace

std::vector<DummyWay>
MakeRoomForEdges(const CombinatorialMap & packed,
                 const CombinatorialMap & map,
                 const StepMatch &        match,
                 DummyStretches &         stretches,
                 FaceDummies &            dummies)
{
  RoomForEdges room(packed, map, stretches, dummies);
  for (int edge = 0; edge < map.Edges(); ++edge)
  {
    if (match.oldHalfEdge[2 * edge] < 0)
    {
      room.Make(edge);
    }
  }
  return room.Take();
}
} // namespace shapeton
