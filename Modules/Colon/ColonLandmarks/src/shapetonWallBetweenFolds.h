#ifndef shapetonWallBetweenFolds_h
#define shapetonWallBetweenFolds_h

#include "shapetonFlatColonAxis.h"
#include "shapetonFlatColonGrid.h"
#include "shapetonHaustralFolds.h"
#include "shapetonTaeniaEvidence.h"

#include <vector>

namespace shapeton
{
/** Evidence of taeniae from the wall between folds, for each row and angle: high where one is likely, 0 on average.
 * Haustra bulge outward between taeniae, so along a taenia the wall is nearer to the axis and less concave. */
std::vector<double>
WallBetweenFolds(const FlatColonGrid &  grid,
                 const FlatColonAxis &  axis,
                 const HaustralFolds &  folds,
                 const TaeniaEvidence & evidence);
} // namespace shapeton

#endif
