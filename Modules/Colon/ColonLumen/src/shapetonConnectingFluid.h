#ifndef shapetonConnectingFluid_h
#define shapetonConnectingFluid_h

#include "shapetonLumenField.h"

namespace shapeton
{
/** Turns other bright matter into fluid of the colon where it connects separate pieces of the lumen of the colon, such
 * as a fluid-filled stretch of the sigmoid between two gas-filled stretches. Returns the voxels.
 *
 * The matter must be as bright as the fluid of the colon and open to both pieces: it adjoins their fluid, or their gas
 * with no wall in between. Only the matter around the shortest path between the pieces is added, because narrow leaks
 * may connect the matter to other bowel and bone. Tagged small bowel usually touches only one piece, because the colon
 * is continuous where it is distended.
 *
 * Also adds small volumes of fluid (up to 2 ml) behind a neck if they share at least 10 mm^2 of surface with the fluid
 * of the colon, and at least 30 % of their surface is open to the lumen. */
VoxelSet
TakeConnectingFluid(LumenField & field);
} // namespace shapeton

#endif
