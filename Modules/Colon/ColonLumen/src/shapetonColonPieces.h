#ifndef shapetonColonPieces_h
#define shapetonColonPieces_h

#include "shapetonColonEvidence.h"

namespace shapeton
{
/** Kinds of gas that are not colon; SmallBowelKind may be colon, except for its width. */
inline const char * const SmallBowelKind = "small bowel or undistended colon";
inline const char * const OutsideKind = "outside air";
inline const char * const LungKind = "lung";
inline const char * const AirwayKind = "airway or esophagus";

/** Pieces of a set that come within 60 mm of the anus, and 30 mm nearer than all known gas and fluid of the colon. Such
 * pieces of bowel are rectum, or sigmoid before it, although as thin as small bowel. None without a known colon.
 * Positions are relative to the box around all gas that may be in a bowel, see ColonExtent. */
std::vector<char>
PiecesNearerToAnus(const ColonEvidence & evidence, const VoxelRuns & set, const RunLabels & labels);

/** Marks the distended pieces as colon. */
void
ChooseCore(ColonEvidence & evidence);

/** Uses the levels: the width of a piece includes fluid of the colon's brightness below it. A piece over much fluid
 * that is far fainter than in the rest of the colon is stomach. If no colon is near the anus, gas there over tagged
 * fluid is rectum or sigmoid, separated from the rest by a collapse, although both together are no wider than small
 * bowel. Returns the pieces identified as these. */
std::vector<int>
ReviewCore(ColonEvidence & evidence);
} // namespace shapeton

#endif
