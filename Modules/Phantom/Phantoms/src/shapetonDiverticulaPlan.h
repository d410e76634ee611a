#ifndef shapetonDiverticulaPlan_h
#define shapetonDiverticulaPlan_h

#include "shapetonColonPlan.h"

#include <vector>

namespace shapeton
{
/** Places up to `count` diverticula, as space permits, in rows next to the taeniae coli, away from the folds, polyps
 * and valve of the plan. A smaller count gives the first ones of a larger count. */
std::vector<DiverticulumPlan>
PlanDiverticula(const ColonPlan & plan, unsigned seed, int count);
} // namespace shapeton

#endif
