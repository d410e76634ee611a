#ifndef shapetonRoomForEdges_h
#define shapetonRoomForEdges_h

#include "shapetonDummyStretches.h"

namespace shapeton
{
/** The way of a new edge through dummies: half-edges of the old packed map, from its first node to its second one. */
struct DummyWay
{
  int              edge;
  std::vector<int> halfEdges;
};

/** Makes room for edges which the next step adds, and says in their stretches where these go through. A dummy that lies
 * between the two ends of an edge goes, or makes room for a leaf; where there are more, the edge runs along them and
 * they stay. Where dummies cannot make room so, all of the face go. */
std::vector<DummyWay>
MakeRoomForEdges(const CombinatorialMap & packed,
                 const CombinatorialMap & map,
                 const StepMatch &        match,
                 DummyStretches &         stretches,
                 FaceDummies &            dummies);
} // namespace shapeton

#endif
