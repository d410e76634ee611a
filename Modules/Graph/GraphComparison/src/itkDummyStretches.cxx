#include "itkDummyStretches.h"

#include <utility>

namespace itk
{
namespace
{
/** Calls `visit` for half-edges around a node from `first` on, once around at most, as long as they are not `known`.
 * Returns the one that ends the stretch; -1 for a node without any. */
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
} // namespace

DummyStretches::DummyStretches(const CombinatorialMap & packed,
                               const CombinatorialMap & map,
                               const StepMatch &        match,
                               FaceDummies &            dummies)
  : m_OfHalfEdge(map.HalfEdges(), -1), m_OfNode(map.Nodes(), -1)
{
  DummyStretch stretch;
  const auto   addDummy = [&](int h) {
    if (dummies.IsDummy(dummies.Head(h)))
    {
      stretch.dummies.push_back(h);
    }
  };
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    if (const int old = match.oldHalfEdge[h]; old >= 0)
    {
      const int oldEnd = WalkStretch(packed, packed.NextAround(old), match.halfEdgeOf, addDummy);
      const int end = WalkStretch(
        map, map.NextAround(h), match.oldHalfEdge, [&stretch](int added) { stretch.added.push_back(added); });
      if (match.oldHalfEdge[end] != oldEnd)
      {
        dummies.DropFacesOf(stretch.dummies);
      }
      m_OfHalfEdge[h] = this->Add(stretch);
    }
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

/** Returns the number of the stretch, which is empty then; -1 when it has been so. */
int
DummyStretches::Add(DummyStretch & stretch)
{
  if (stretch.dummies.empty() && stretch.added.empty())
  {
    return -1;
  }
  const int number = static_cast<int>(m_All.size());
  for (const int h : stretch.added)
  {
    m_OfHalfEdge[h] = number;
  }
  m_All.push_back(std::exchange(stretch, {}));
  return number;
}
} // namespace itk
