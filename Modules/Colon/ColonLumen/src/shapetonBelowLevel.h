#ifndef shapetonBelowLevel_h
#define shapetonBelowLevel_h

#include "shapetonLevels.h"

namespace shapeton
{
/** Measures what lies below a level, `below` and `edge`, while its `floors` are still indices into these floors.
 * `tissue` is the intensity of soft tissue. */
void
MeasureBelow(const ColonGrid &          grid,
             const std::vector<float> & hu,
             const std::vector<Floor> & floors,
             const Fall &               fall,
             double                     tissue,
             Level &                    level);
} // namespace shapeton

#endif
