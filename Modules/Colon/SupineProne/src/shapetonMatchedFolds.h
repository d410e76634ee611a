#ifndef shapetonMatchedFolds_h
#define shapetonMatchedFolds_h

#include "shapetonColonPair.h"
#include "shapetonFoldMatching.h"
#include "shapetonSmoothCorrection.h"

#include <functional>

namespace shapeton
{
/** Where a map takes a place of the source. */
using PlaceMap = std::function<CylinderPlace(const CylinderPlace &)>;

/** MatchFolds() of all folds of the pair, those of the source being where the map takes them. */
FoldMatching
MatchFoldsAbout(const ColonPair & pair, const PlaceMap & map, FoldMatchingMethod method);

/** How much more than the map moves them matched folds are to move: of each pair the middle, then both ends, paired as
 * they lie. */
std::vector<DisplacementConstraint>
ConstraintsOfFolds(const ColonPair & pair, const PlaceMap & map, const FoldMatching & matching);
} // namespace shapeton

#endif
