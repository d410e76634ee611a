#ifndef shapetonWallBetweenFolds_h
#define shapetonWallBetweenFolds_h

#include "shapetonFlatColonAxis.h"
#include "shapetonFlatColonGrid.h"
#include "shapetonHaustralFolds.h"
#include "shapetonTaeniaEvidence.h"

#include <vector>

namespace shapeton
{
/** What the wall between folds tells of taeniae, for each row and angle of the evidence: high where one may run, 0 on
 * average. Haustra bulge outwards between taeniae, so that along a taenia the wall lies nearer to the axis, and is less
 * hollow. */
std::vector<double>
WallBetweenFolds(const FlatColonGrid &  grid,
                 const FlatColonAxis &  axis,
                 const HaustralFolds &  folds,
                 const TaeniaEvidence & evidence);
} // namespace shapeton

#endif
