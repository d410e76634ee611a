#ifndef shapetonConnectingFluid_h
#define shapetonConnectingFluid_h

#include "shapetonLumenField.h"

namespace shapeton
{
/** Turns other bright matter into fluid of the colon where it connects separate pieces of the lumen of the colon, such
 * as a stretch of the sigmoid filled with fluid between gas. Returns the voxels.
 *
 * The matter is as bright as the fluid of the colon and open to each of the two pieces: it adjoins their fluid, or
 * their gas with no wall in between. It is taken around the shortest path between the pieces only, because narrow leaks
 * may connect it to other bowel and bone. Tagged small bowel that touches the colon touches one piece of it, as a rule:
 * the colon is continuous where it is distended.
 *
 * Also takes rests of fluid (up to 2 ml) that a neck cuts off: they adjoin fluid of the colon over at least 10 mm^2,
 * and 30 % of their surface are open to its lumen. */
VoxelSet
TakeConnectingFluid(LumenField & field);
} // namespace shapeton

#endif
