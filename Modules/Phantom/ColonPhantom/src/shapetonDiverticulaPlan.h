#ifndef shapetonDiverticulaPlan_h
#define shapetonDiverticulaPlan_h

#include "shapetonColonPlan.h"

#include <vector>

namespace shapeton
{
/** Places `count` diverticula, fewer where there is no room, in rows beside the taeniae: clear of the folds, polyps and
 * valve of the plan. A smaller count gives the first of a larger one. */
std::vector<DiverticulumPlan>
PlanDiverticula(const ColonPlan & plan, unsigned seed, int count);
} // namespace shapeton

#endif
