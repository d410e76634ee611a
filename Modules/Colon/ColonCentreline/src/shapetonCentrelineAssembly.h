#ifndef shapetonCentrelineAssembly_h
#define shapetonCentrelineAssembly_h

#include "shapetonColonCentreline.h"
#include "shapetonCurveShape.h"
#include "shapetonLumenChoice.h"
#include "shapetonPieceLine.h"
#include "shapetonPieceOrder.h"

namespace shapeton
{
/** One curve from the lines of the pieces in their order, each directed from the rectum to the caecum, with its arrays,
 * gaps, pieces, lengths and warnings. */
ColonCentreline
AssembleCentreline(const LumenNetwork &             network,
                   const DistanceField &            field,
                   const std::vector<PieceLine> &   lines,
                   const std::vector<PlacedPiece> & order,
                   const ColonCentrelineOptions &   options);

/** Lists the lines that are not used, with a warning for each. */
void
AddUnusedLines(const LumenNetwork &             network,
               const std::vector<PieceLine> &   lines,
               const std::vector<PlacedPiece> & order,
               ColonCentreline &                result);

/** Lists the components that are not used, with a warning for each large one. */
void
AddUnusedComponents(const LumenMask *       lumen,
                    const LumenComponents & components,
                    const LumenChoice &     choice,
                    ColonCentreline &       result);

/** Lists the places where loops touch, with a warning for each. */
void
AddMerges(const LumenNetwork & network, ColonCentreline & result);
} // namespace shapeton

#endif
