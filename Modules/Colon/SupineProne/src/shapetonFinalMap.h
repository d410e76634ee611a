#ifndef shapetonFinalMap_h
#define shapetonFinalMap_h

#include "shapetonCorrectedWarp.h"
#include "shapetonSupineProneRegistration.h"

namespace shapeton
{
/** Samples a map at the nodes of the final map: every 4 mm and 10 degrees. */
CylinderNodes
NodesOf(const ColonPair & pair, const RowMap & map);

/** Sets the map, matching, matches, exclusions, and figures of the registration. */
void
ProjectMap(const ColonPair &         pair,
           const CorrectedWarp &     corrected,
           double                    greatestDilatation,
           SupineProneRegistration & registration,
           const Progress &          progress);

/** Sets the same members using FindPublishedMap() about the frame of the registration; warns about flipped
 * triangles. */
void
MapAsPublished(const ColonPair &          pair,
               const SupineProneOptions & options,
               SupineProneRegistration &  registration,
               const Progress &           progress);
} // namespace shapeton

#endif
