#ifndef shapetonDummyStretches_h
#define shapetonDummyStretches_h

#include "shapetonFaceDummies.h"
#include "shapetonStepMatch.h"

namespace shapeton
{
/** The elements around a node between successive half-edges that exist in both steps; all elements around a node
 * without such half-edges. */
struct DummyStretch
{
  std::vector<int> dummies; ///< half-edges of the old packed map that lead to dummies
  std::vector<int> added;   ///< half-edges of the new graph
  std::vector<int> places;  ///< per added half-edge: the dummy that is removed or on its path, or -1
};

/** All nonempty stretches. Dummies of a stretch are removed if the corner between its half-edges changed. With `reach`
 * = k >= 1, this also applies where edges are added, and to dummies up to k - 1 neighbors away. */
class DummyStretches
{
public:
  DummyStretches(const CombinatorialMap & packed,
                 const CombinatorialMap & map,
                 const StepMatch &        match,
                 FaceDummies &            dummies,
                 int                      reach);

  /** The stretch after a half-edge that exists in both steps, or around a new half-edge; null if empty. */
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
  /** The stretch around a node without edges; null if empty. */
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
