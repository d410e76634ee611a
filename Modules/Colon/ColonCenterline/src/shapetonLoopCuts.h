#ifndef shapetonLoopCuts_h
#define shapetonLoopCuts_h

#include "shapetonCellTree.h"

namespace shapeton
{
/** Cuts holes between the end of one stretch of colon and the side of another.
 *
 * If the colon is collapsed and its parts touch elsewhere, the hole is their only connection and closes no ring. It
 * appears as a long side branch. It is cut if joining the parts end to end across gaps is clearly better, that is, if
 * the joins are shorter than the side branches. Returns the cut passages and removes them from the tree. */
std::vector<int>
CutLoops(const LumenGrid & grid, const LumenCells & cells, CellTree & tree);
} // namespace shapeton

#endif
