#ifndef shapetonMatchedFolds_h
#define shapetonMatchedFolds_h

#include "shapetonColonPair.h"
#include "shapetonFoldMatching.h"
#include "shapetonSmoothCorrection.h"

#include <functional>

namespace shapeton
{
/** Maps a source position to the target. */
using PlaceMap = std::function<CylinderPlace(const CylinderPlace &)>;

/** Applies MatchFolds() to all folds of the pair after mapping the source folds. */
FoldMatching
MatchFoldsAbout(const ColonPair & pair, const PlaceMap & map, FoldMatchingMethod method);

/** Residual displacements of matched folds under the map: for each pair, that of the center, then those of both ends,
 * which are paired by position. */
std::vector<DisplacementConstraint>
ConstraintsOfFolds(const ColonPair & pair, const PlaceMap & map, const FoldMatching & matching);
} // namespace shapeton

#endif
