#include "shapetonDummyStretches.h"

#include <utility>

namespace shapeton
{
namespace
{
/** Calls `visit` for the half-edges around a node, starting at `first`, until one is `known` or all are visited.
 * Returns the half-edge that ends the stretch, or `first` if none is known. */
template <typename TVisit>
int
WalkStretch(const CombinatorialMap & map, int first, const std::vector<int> & known, const TVisit & visit)
{
  if (first < 0)
  {
    return first;
  }
  int h = first;
  do
  {
    if (known[h] >= 0)
    {
      return h;
    }
    visit(h);
    h = map.NextAround(h);
  } while (h != first);
  return h;
}

/** Corners shared by both steps, each given by the half-edge before it, which exists in both. */
class SameCorners
{
public:
  SameCorners(const CombinatorialMap & packed, const CombinatorialMap & map, const StepMatch & match)
    : m_Next(map.HalfEdges(), -1), m_Previous(map.HalfEdges(), -1), m_IsSame(map.HalfEdges(), 0)
  {
    const auto skip = [](int) {};
    for (int h = 0; h < map.HalfEdges(); ++h)
    {
      if (const int old = match.oldHalfEdge[h]; old >= 0)
      {
        m_Next[h] = WalkStretch(map, map.NextAround(h), match.oldHalfEdge, skip);
        m_Previous[m_Next[h]] = h;
        m_IsSame[h] =
          match.oldHalfEdge[m_Next[h]] == WalkStretch(packed, packed.NextAround(old), match.halfEdgeOf, skip);
      }
    }
    this->JudgeChains();
  }
  bool
  IsSame(int halfEdge) const
  {
    return m_IsSame[halfEdge] != 0;
  }

private:
  /** At a node with one or two half-edges the order is unchanged even if the surrounding part of the graph flipped. */
  bool
  IsInChain(int halfEdge) const
  {
    return m_Next[halfEdge] >= 0 && m_Next[m_Next[halfEdge]] == halfEdge;
  }
  /** Follows the face to the first corner that is not in a chain; returns the start if there is none. */
  template <typename TVisit>
  int
  Walk(int halfEdge, bool isForward, const TVisit & visit) const
  {
    int h = halfEdge;
    do
    {
      visit(h);
      h = isForward ? m_Previous[h ^ 1] : m_Next[h] ^ 1;
    } while (this->IsInChain(h) && h != halfEdge);
    return h;
  }
  /** The corners of a chain are matched at both of its ends. */
  void
  JudgeChains()
  {
    std::vector<char> isDone(m_Next.size(), 0);
    for (int h = 0; h < static_cast<int>(m_Next.size()); ++h)
    {
      if (this->IsInChain(h) && !isDone[h])
      {
        const auto skip = [](int) {};
        const bool isSame = m_IsSame[this->Walk(h, true, skip)] && m_IsSame[this->Walk(h, false, skip)];
        const auto judge = [&](int k) {
          isDone[k] = 1;
          m_IsSame[k] = isSame;
        };
        this->Walk(h, true, judge);
        this->Walk(h, false, judge);
      }
    }
  }

  std::vector<int>  m_Next;
  std::vector<int>  m_Previous;
  std::vector<char> m_IsSame;
};
} // namespace

DummyStretches::DummyStretches(const CombinatorialMap & packed,
                               const CombinatorialMap & map,
                               const StepMatch &        match,
                               FaceDummies &            dummies,
                               int                      reach)
  : m_OfHalfEdge(map.HalfEdges(), -1), m_OfNode(map.Nodes(), -1)
{
  const SameCorners corners(packed, map, match);
  DummyStretch      stretch;
  const auto        addDummy = [&](int h) {
    if (dummies.IsDummy(dummies.Head(h)))
    {
      stretch.dummies.push_back(h);
    }
  };
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    if (const int old = match.oldHalfEdge[h]; old >= 0)
    {
      WalkStretch(packed, packed.NextAround(old), match.halfEdgeOf, addDummy);
      WalkStretch(map, map.NextAround(h), match.oldHalfEdge, [&stretch](int added) { stretch.added.push_back(added); });
      if (!corners.IsSame(h) || (reach > 0 && !stretch.added.empty()))
      {
        dummies.DropHeads(stretch.dummies);
      }
      m_OfHalfEdge[h] = this->Add(stretch);
    }
  }
  for (int step = 1; step < reach; ++step)
  {
    dummies.DropNeighbors();
  }
  for (int node = 0; node < map.Nodes(); ++node)
  {
    if (map.FirstAround(node) < 0 && match.oldNode[node] >= 0)
    {
      WalkStretch(packed, packed.FirstAround(match.oldNode[node]), match.halfEdgeOf, addDummy);
      m_OfNode[node] = this->Add(stretch);
    }
  }
}

/** Empties the stretch and returns its number; -1 if it was already empty. */
int
DummyStretches::Add(DummyStretch & stretch)
{
  if (stretch.dummies.empty() && stretch.added.empty())
  {
    return -1;
  }
  const int number = static_cast<int>(m_All.size());
  stretch.places.assign(stretch.added.size(), -1);
  for (const int h : stretch.added)
  {
    m_OfHalfEdge[h] = number;
  }
  m_All.push_back(std::exchange(stretch, {}));
  return number;
}
} // namespace shapeton
