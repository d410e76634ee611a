#ifndef shapetonWallBetweenFolds_h
#define shapetonWallBetweenFolds_h

#include "shapetonFlatColonAxis.h"
#include "shapetonFlatColonGrid.h"
#include "shapetonHaustralFolds.h"
#include "shapetonTaeniaEvidence.h"

#include <vector>

namespace shapeton
{
/** Evidence of taeniae, derived from the wall between folds, for each row and angle. It is high where a taenia is
 * likely and has zero mean. Haustra bulge outward between taeniae, so the wall along a taenia is nearer to the axis and
 * less concave. */
std::vector<double>
WallBetweenFolds(const FlatColonGrid &  grid,
                 const FlatColonAxis &  axis,
                 const HaustralFolds &  folds,
                 const TaeniaEvidence & evidence);
} // namespace shapeton

#endif
