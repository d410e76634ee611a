#ifndef shapetonRoomForEdges_h
#define shapetonRoomForEdges_h

#include "shapetonDummyStretches.h"

namespace shapeton
{
/** Path of a new edge through dummies: half-edges of the old packed map, from its first node to its second one. */
struct DummyWay
{
  int              edge;
  std::vector<int> halfEdges;
};

/** Makes room for edges added by the next step, and records their paths in the stretches. A single dummy between the
 * ends of an edge is removed, or shifted for a leaf. If there are more, the edge is routed along them and they are
 * kept. If dummies cannot make room this way, all dummies of the face are removed. */
std::vector<DummyWay>
MakeRoomForEdges(const CombinatorialMap & packed,
                 const CombinatorialMap & map,
                 const StepMatch &        match,
                 DummyStretches &         stretches,
                 FaceDummies &            dummies);
} // namespace shapeton

#endif
