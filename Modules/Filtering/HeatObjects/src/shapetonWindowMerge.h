#ifndef shapetonWindowMerge_h
#define shapetonWindowMerge_h

#include "shapetonHeatObjects.h"

namespace shapeton
{
/** Adds objects of a later window to a list as FindWindowObjects() does; returns the sum of the probabilities of the
 * added ones. The labels of both lists have the same grid. */
double
AddWindowObjects(const HeatObjectList & found, HeatObjectList & list);

double
SumOfProbabilities(const std::vector<HeatObject> & objects);
} // namespace shapeton

#endif
