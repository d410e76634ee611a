#ifndef shapetonLoopCuts_h
#define shapetonLoopCuts_h

#include "shapetonCellTree.h"

namespace shapeton
{
/** Cuts holes that hang a stretch of colon on the side of another one.
 *
 * Where the colon is collapsed and its parts touch elsewhere, the hole is the only way between them, and no ring
 * betrays it. It shows as a long side branch. Such a hole is cut when the parts, joined end to end over gaps, make a
 * clearly better colon: shorter joins than side branches. Returns the passages; the tree is changed. */
std::vector<int>
CutLoops(const LumenGrid & grid, const LumenCells & cells, CellTree & tree);
} // namespace shapeton

#endif
