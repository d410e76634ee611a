#ifndef itkRoomForEdges_h
#define itkRoomForEdges_h

#include "itkDummyStretches.h"

namespace itk
{
/** Takes the fewest dummies out that are in the way of edges which the next step adds, and says in their stretches
 * where these go through. Where dummies cannot make room one by one, all of the face go. */
void
MakeRoomForEdges(const CombinatorialMap & packed,
                 const CombinatorialMap & map,
                 const StepMatch &        match,
                 DummyStretches &         stretches,
                 FaceDummies &            dummies);
} // namespace itk

#endif
