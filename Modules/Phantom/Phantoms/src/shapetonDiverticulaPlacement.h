#ifndef shapetonDiverticulaPlacement_h
#define shapetonDiverticulaPlacement_h

#include "shapetonColonPlan.h"
#include "shapetonDiverticulumBody.h"

#include <vector>

namespace shapeton
{
class ColonField;

/** The diverticula of a patient in a position, for a field without diverticula. A sac too close to the wall of the
 * colon, to another sac, to spine or body wall is tilted or made smaller; without room it is omitted. */
std::vector<DiverticulumBody>
PlaceDiverticula(const ColonField & field, const std::vector<DiverticulumPlan> & plans);
} // namespace shapeton

#endif
