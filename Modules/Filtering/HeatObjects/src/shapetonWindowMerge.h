#ifndef shapetonWindowMerge_h
#define shapetonWindowMerge_h

#include "shapetonHeatObjects.h"

namespace shapeton
{
/** Adds the objects of a later window to a list, as FindWindowObjects(); returns the sum of their probabilities. Both
 * lists have labels of one grid. */
double
AddWindowObjects(const HeatObjectList & found, HeatObjectList & list);

double
SumOfProbabilities(const std::vector<HeatObject> & objects);
} // namespace shapeton

#endif
