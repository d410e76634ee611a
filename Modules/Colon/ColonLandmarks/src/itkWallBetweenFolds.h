#ifndef itkWallBetweenFolds_h
#define itkWallBetweenFolds_h

#include "itkFlatColonAxis.h"
#include "itkFlatColonGrid.h"
#include "itkHaustralFolds.h"
#include "itkTaeniaEvidence.h"

#include <vector>

namespace itk
{
/** What the wall between folds tells of taeniae, for each row and angle of the evidence: high where one may run, 0 on
 * average. Haustra bulge outwards between taeniae, so that along a taenia the wall lies nearer to the axis, and is less
 * hollow. */
std::vector<double>
WallBetweenFolds(const FlatColonGrid &  grid,
                 const FlatColonAxis &  axis,
                 const HaustralFolds &  folds,
                 const TaeniaEvidence & evidence);
} // namespace itk

#endif
