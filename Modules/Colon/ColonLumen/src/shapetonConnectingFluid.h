#ifndef shapetonConnectingFluid_h
#define shapetonConnectingFluid_h

#include "shapetonLumenField.h"

namespace shapeton
{
/** Turns other bright matter into fluid of the colon where it connects separate pieces of the lumen of the colon, such
 * as a stretch of the sigmoid filled with fluid between gas. Returns the voxels.
 *
 * The matter is as bright as the fluid of the colon and open to each of the two pieces: it adjoins their fluid, or
 * their gas with no wall in between. Only the matter around the shortest path between the pieces is taken, because
 * narrow leaks may connect it to other bowel and bone. Tagged small bowel usually touches only one piece, because the
 * colon is continuous where it is distended.
 *
 * Also takes small volumes of fluid (up to 2 ml) behind a neck. They share at least 10 mm^2 with the fluid of the
 * colon, and at least 30 % of their surface is open to the lumen. */
VoxelSet
TakeConnectingFluid(LumenField & field);
} // namespace shapeton

#endif
