#ifndef shapetonDiverticulaPlacement_h
#define shapetonDiverticulaPlacement_h

#include "shapetonColonPlan.h"
#include "shapetonDiverticulumBody.h"

#include <vector>

namespace shapeton
{
class ColonField;

/** The diverticula of a patient in a position, on a field that has none yet. A sac that would come too near to the wall
 * of the colon, to another sac, to spine or body wall leans over or is smaller; one that finds no room is left out. */
std::vector<DiverticulumBody>
PlaceDiverticula(const ColonField & field, const std::vector<DiverticulumPlan> & plans);
} // namespace shapeton

#endif
