#ifndef shapetonFluidWithoutGas_h
#define shapetonFluidWithoutGas_h

#include "shapetonColonSearch.h"

namespace shapeton
{
/** A stretch of the colon filled with fluid alone. */
struct FluidWithoutGas
{
  double          ml{ 0.0 };
  bool            isRectum{ false };       ///< taken as nothing else is near the anus
  Eigen::Vector3d centre{ 0.0, 0.0, 0.0 }; ///< of the largest ball in it, LPS, mm
};

/** Takes bright matter without a level for colon, where its calibre is that of no small bowel: at least 50 ml, an
 * inscribed radius of 14 mm or more, longer than wide, which a bladder is not, and as bright as the colon's fluid.
 * Only where fluid is tagged so well (300 HU above tissue) that no bone of that width is as bright. Each becomes a seed
 * point of `evidence`. Nearer to the anus than the colon (see PiecesNearerToAnus()) 20 ml and 10 mm are
 * enough. */
std::vector<FluidWithoutGas>
TakeFluidWithoutGas(ColonEvidence & evidence);
} // namespace shapeton

#endif
