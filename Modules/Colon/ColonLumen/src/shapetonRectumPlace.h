#ifndef shapetonRectumPlace_h
#define shapetonRectumPlace_h

#include "shapetonColonSearch.h"

namespace shapeton
{
/** Pieces of a set that come within 60 mm of the anus, and 30 mm nearer than all gas and fluid that is known as colon.
 * What lies there and may lie in a bowel is the rectum, or the sigmoid before it, though it is as thin as small bowel.
 * None while there is no colon. Places are judged by the box around all gas that may lie in a bowel, see ColonExtent.
 */
std::vector<char>
PiecesNearerToAnus(const ColonEvidence & evidence, const VoxelRuns & set, const RunLabels & labels);
} // namespace shapeton

#endif
