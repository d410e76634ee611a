#ifndef itkCentrelineAssembly_h
#define itkCentrelineAssembly_h

#include "itkColonCentreline.h"
#include "itkCurveShape.h"
#include "itkLumenChoice.h"
#include "itkPieceLine.h"
#include "itkPieceOrder.h"

namespace itk
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
} // namespace itk

#endif
