#ifndef shapetonDiverticulaPlan_h
#define shapetonDiverticulaPlan_h

#include "shapetonColonPlan.h"

#include <vector>

namespace shapeton
{
/** Places up to `count` diverticula, as space permits, in rows next to the taeniae coli, away from the folds, the
 * polyps and the valve of the plan. The result for a smaller count is a prefix of the result for a larger count. */
std::vector<DiverticulumPlan>
PlanDiverticula(const ColonPlan & plan, unsigned seed, int count);
} // namespace shapeton

#endif
