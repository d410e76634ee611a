#ifndef shapetonCenterlineAssembly_h
#define shapetonCenterlineAssembly_h

#include "shapetonColonCenterline.h"
#include "shapetonCurveShape.h"
#include "shapetonLumenChoice.h"
#include "shapetonPieceLine.h"
#include "shapetonPieceOrder.h"

namespace shapeton
{
/** Assembles one curve with arrays, gaps, pieces, lengths and warnings from the ordered lines of the pieces, each
 * directed from the rectum to the cecum. */
ColonCenterline
AssembleCenterline(const LumenNetwork &             network,
                   const DistanceField &            field,
                   const std::vector<PieceLine> &   lines,
                   const std::vector<PlacedPiece> & order,
                   const ColonCenterlineOptions &   options);

/** Lists the unused lines, with a warning for each. */
void
AddUnusedLines(const LumenNetwork &             network,
               const std::vector<PieceLine> &   lines,
               const std::vector<PlacedPiece> & order,
               ColonCenterline &                result);

/** Lists the unused components, with a warning for each large one. */
void
AddUnusedComponents(const LumenMask *       lumen,
                    const LumenComponents & components,
                    const LumenChoice &     choice,
                    ColonCenterline &       result);

/** Lists the contacts between loops, with a warning for each. */
void
AddMerges(const LumenNetwork & network, ColonCenterline & result);
} // namespace shapeton

#endif
