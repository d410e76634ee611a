#ifndef shapetonLoopCuts_h
#define shapetonLoopCuts_h

#include "shapetonCellTree.h"

namespace shapeton
{
/** Cuts holes that connect an end of one stretch of colon to the side of another.
 *
 * Where the colon is collapsed and its parts touch elsewhere, the hole is their only connection, and no ring reveals
 * it. It shows as a long side branch. Such a hole is cut if joining the parts end to end over gaps gives a clearly
 * better colon: joins shorter than the side branches. Returns the passages; modifies the tree. */
std::vector<int>
CutLoops(const LumenGrid & grid, const LumenCells & cells, CellTree & tree);
} // namespace shapeton

#endif
