#ifndef shapetonDummyStretches_h
#define shapetonDummyStretches_h

#include "shapetonFaceDummies.h"
#include "shapetonStepMatch.h"

namespace shapeton
{
/** What lies between two half-edges that both steps have, one after the other around a node; or all around a node that
 * has none. */
struct DummyStretch
{
  std::vector<int> dummies; ///< half-edges of the old packed map that lead to dummies
  std::vector<int> added;   ///< half-edges of the new graph
  std::vector<int> places;  ///< of each added one: which of the dummies makes room for it, or is on its way; -1: none
};

/** All stretches that are not empty. Where the corner between its half-edges has become another one the dummies of a
 * stretch go; with `reach` >= 1 also those where edges are added, and with k those beside them k - 1 times. */
class DummyStretches
{
public:
  DummyStretches(const CombinatorialMap & packed,
                 const CombinatorialMap & map,
                 const StepMatch &        match,
                 FaceDummies &            dummies,
                 int                      reach);

  /** After a half-edge that both steps have, or around a new one; null for an empty one. */
  DummyStretch *
  Of(int halfEdge)
  {
    return m_OfHalfEdge[halfEdge] < 0 ? nullptr : &m_All[m_OfHalfEdge[halfEdge]];
  }
  const DummyStretch *
  Of(int halfEdge) const
  {
    return m_OfHalfEdge[halfEdge] < 0 ? nullptr : &m_All[m_OfHalfEdge[halfEdge]];
  }
  /** Around a node without edges; null for an empty one. */
  const DummyStretch *
  Around(int node) const
  {
    return m_OfNode[node] < 0 ? nullptr : &m_All[m_OfNode[node]];
  }

private:
  int
  Add(DummyStretch & stretch);

  std::vector<DummyStretch> m_All;
  std::vector<int>          m_OfHalfEdge; ///< -1: empty
  std::vector<int>          m_OfNode;
};
} // namespace shapeton

#endif
