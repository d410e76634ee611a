#include "itkRoomForEdges.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace itk
{
namespace
{
class RoomForEdges
{
public:
  RoomForEdges(const CombinatorialMap & packed,
               const CombinatorialMap & map,
               DummyStretches &         stretches,
               FaceDummies &            dummies)
    : m_Packed(packed), m_Map(map), m_Stretches(stretches), m_Dummies(dummies)
  {}

  /** For an edge that is new. */
  void
  Make(int halfEdge)
  {
    const std::array<DummyStretch *, 2> ends{ m_Stretches.Of(halfEdge),
                                              m_Stretches.Of(CombinatorialMap::Twin(halfEdge)) };
    const auto                          hasDummies = [this](const DummyStretch * end) { return this->HasDummies(end); };
    if (std::none_of(ends.begin(), ends.end(), hasDummies) || this->MakeBetween(halfEdge, ends[0], ends[1]))
    {
      return;
    }
    for (const DummyStretch * const end : ends)
    {
      if (end)
      {
        m_Dummies.DropFacesOf(end->dummies);
      }
    }
  }

private:
  bool
  HasDummies(const DummyStretch * stretch) const
  {
    return stretch && std::any_of(stretch->dummies.begin(), stretch->dummies.end(), [this](int h) {
             return m_Dummies.Stays(m_Dummies.Head(h));
           });
  }
  bool
  IsLeaf(int halfEdge, const DummyStretch * stretch) const
  {
    return !stretch && m_Map.NextAround(halfEdge) == halfEdge;
  }
  bool
  MakeBetween(int halfEdge, DummyStretch * from, DummyStretch * to);
  bool
  MakeInTheMiddle(DummyStretch & stretch);
  bool
  MakeAlongPath(DummyStretch & from, DummyStretch & to);
  std::vector<int>
  ShortestPath(const DummyStretch & from, const DummyStretch & to) const;

  const CombinatorialMap & m_Packed;
  const CombinatorialMap & m_Map;
  DummyStretches &         m_Stretches;
  FaceDummies &            m_Dummies;
};

/** False when dummies are in the way that cannot make room. */
bool
RoomForEdges::MakeBetween(int halfEdge, DummyStretch * from, DummyStretch * to)
{
  if (this->IsLeaf(CombinatorialMap::Twin(halfEdge), to))
  {
    return this->MakeInTheMiddle(*from);
  }
  if (this->IsLeaf(halfEdge, from))
  {
    return this->MakeInTheMiddle(*to);
  }
  return from && to && this->MakeAlongPath(*from, *to);
}

/** For an edge to a leaf. */
bool
RoomForEdges::MakeInTheMiddle(DummyStretch & stretch)
{
  const int middle = static_cast<int>(stretch.dummies.size() / 2);
  const int dummy = m_Dummies.Head(stretch.dummies[middle]);
  if (stretch.added.size() != 1 || !m_Dummies.Stays(dummy))
  {
    return false;
  }
  stretch.place = middle;
  m_Dummies.Drop(dummy);
  return true;
}

/** Takes out the dummies between the two ends of an edge. False when there is no way, or when one end has several new
 * edges. */
bool
RoomForEdges::MakeAlongPath(DummyStretch & from, DummyStretch & to)
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
  const auto placeOf = [this](const DummyStretch & stretch, int dummy) {
    const auto isIt = [this, dummy](int h) { return m_Dummies.Head(h) == dummy; };
    return static_cast<int>(std::find_if(stretch.dummies.begin(), stretch.dummies.end(), isIt) -
                            stretch.dummies.begin());
  };
  from.place = placeOf(from, path.front());
  to.place = placeOf(to, path.back());
  for (const int dummy : path)
  {
    m_Dummies.Drop(dummy);
  }
  return true;
}

/** Of dummies, each one beside the next, from one end of an edge to the other; empty when there is none. */
std::vector<int>
RoomForEdges::ShortestPath(const DummyStretch & from, const DummyStretch & to) const
{
  std::unordered_map<int, int> before;
  std::vector<int>             queue;
  const auto                   meet = [&](int node, int last) {
    if (m_Dummies.IsDummy(node) && m_Dummies.Stays(node) && before.emplace(node, last).second)
    {
      queue.push_back(node);
    }
  };
  for (const int h : from.dummies)
  {
    meet(m_Dummies.Head(h), -1);
  }
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    const int node = queue[i];
    if (std::any_of(to.dummies.begin(), to.dummies.end(), [&](int h) { return m_Dummies.Head(h) == node; }))
    {
      std::vector<int> path;
      for (int dummy = node; dummy >= 0; dummy = before[dummy])
      {
        path.push_back(dummy);
      }
      std::reverse(path.begin(), path.end());
      return path;
    }
    for (const int h : m_Packed.Around(node))
    {
      meet(m_Dummies.Head(h), node);
    }
  }
  return {};
}
} // namespace

void
MakeRoomForEdges(const CombinatorialMap & packed,
                 const CombinatorialMap & map,
                 const StepMatch &        match,
                 DummyStretches &         stretches,
                 FaceDummies &            dummies)
{
  RoomForEdges room(packed, map, stretches, dummies);
  for (int h = 0; h < map.HalfEdges(); h += 2)
  {
    if (match.oldHalfEdge[h] < 0)
    {
      room.Make(h);
    }
  }
}
} // namespace itk
