#ifndef shapetonMatchedFolds_h
#define shapetonMatchedFolds_h

#include "shapetonColonPair.h"
#include "shapetonFoldMatching.h"
#include "shapetonSmoothCorrection.h"

#include <functional>

namespace shapeton
{
/** Maps a place of the source to the target. */
using PlaceMap = std::function<CylinderPlace(const CylinderPlace &)>;

/** MatchFolds() for all folds of the pair, with those of the source at their mapped places. */
FoldMatching
MatchFoldsAbout(const ColonPair & pair, const PlaceMap & map, FoldMatchingMethod method);

/** Displacements of matched folds in addition to the map: the center of each pair, then both ends, paired by
 * position. */
std::vector<DisplacementConstraint>
ConstraintsOfFolds(const ColonPair & pair, const PlaceMap & map, const FoldMatching & matching);
} // namespace shapeton

#endif
