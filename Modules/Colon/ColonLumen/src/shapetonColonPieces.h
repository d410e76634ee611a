#ifndef shapetonColonPieces_h
#define shapetonColonPieces_h

#include "shapetonColonEvidence.h"

namespace shapeton
{
/** Kinds of gas that are not colon; SmallBowelKind may be colon but for its width. */
inline const char * const SmallBowelKind = "small bowel or undistended colon";
inline const char * const OutsideKind = "outside air";
inline const char * const LungKind = "lung";
inline const char * const AirwayKind = "airway or esophagus";

/** Pieces of a set that come within 60 mm of the anus, and 30 mm nearer than all gas and fluid that is known as colon.
 * What lies there and may lie in a bowel is the rectum, or the sigmoid before it, though it is as thin as small bowel.
 * None while there is no colon. Places are judged by the box around all gas that may lie in a bowel, see ColonExtent.
 */
std::vector<char>
PiecesNearerToAnus(const ColonEvidence & evidence, const VoxelRuns & set, const RunLabels & labels);

/** Marks the distended pieces as colon. */
void
ChooseCore(ColonEvidence & evidence);

/** With the levels known: a piece with fluid of the colon's brightness below it is as wide as both together. A piece
 * over much fluid that is far fainter than the rest of the colon's is stomach. Where no colon comes near the anus,
 * what lies there over tagged fluid is the rectum or the sigmoid, which a collapse parts from the rest, though both
 * together are no wider than small bowel. Returns the pieces that are taken for these. */
std::vector<int>
ReviewCore(ColonEvidence & evidence);
} // namespace shapeton

#endif
