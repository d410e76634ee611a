#ifndef shapetonDiverticulaPlacement_h
#define shapetonDiverticulaPlacement_h

#include "shapetonColonPlan.h"
#include "shapetonDiverticulumBody.h"

#include <vector>

namespace shapeton
{
class ColonField;

/** Places the diverticula of a patient in a position, for a field without diverticula. A sac too close to the wall of
 * the colon, another sac, the spine or the body wall is tilted or made smaller; if it still does not fit, it is
 * omitted. */
std::vector<DiverticulumBody>
PlaceDiverticula(const ColonField & field, const std::vector<DiverticulumPlan> & plans);
} // namespace shapeton

#endif
