#ifndef shapetonColonCore_h
#define shapetonColonCore_h

#include "shapetonColonSearch.h"

namespace shapeton
{
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
