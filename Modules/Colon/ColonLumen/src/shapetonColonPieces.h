#ifndef shapetonColonPieces_h
#define shapetonColonPieces_h

#include "shapetonColonEvidence.h"

namespace shapeton
{
/** Kinds of gas outside the colon; SmallBowelKind may be a narrow colon. */
inline const char * const SmallBowelKind = "small bowel or undistended colon";
inline const char * const OutsideKind = "outside air";
inline const char * const LungKind = "lung";
inline const char * const AirwayKind = "airway or esophagus";

/** Pieces of a set that are within 60 mm of the anus and at least 30 mm nearer to it than all known gas and fluid of
 * the colon. Such pieces are rectum or sigmoid, even if they are as narrow as small bowel. Empty if no colon is known.
 * Positions are relative to the bounding box of all gas that may be in a bowel, see ColonExtent. */
std::vector<char>
PiecesNearerToAnus(const ColonEvidence & evidence, const VoxelRuns & set, const RunLabels & labels);

/** Marks the distended pieces as colon. */
void
ChooseCore(ColonEvidence & evidence);

/** Refines the choice using the levels. The width of a piece includes the fluid below it if this fluid is as bright as
 * the fluid in the colon. A piece above a large amount of much fainter fluid is stomach. If no colon is near the anus,
 * gas there above tagged fluid is rectum or sigmoid, separated from the rest by a collapsed stretch, even if it is only
 * as wide as small bowel. Returns these pieces. */
std::vector<int>
ReviewCore(ColonEvidence & evidence);
} // namespace shapeton

#endif
