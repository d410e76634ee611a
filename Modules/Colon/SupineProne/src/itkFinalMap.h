#ifndef itkFinalMap_h
#define itkFinalMap_h

#include "itkCorrectedWarp.h"
#include "itkSupineProneRegistration.h"

namespace itk
{
/** A map at the nodes of the final one: every 4 mm and 10 degrees. */
CylinderNodes
NodesOf(const ColonPair & pair, const RowMap & map);

/** Fills in map, matches, what is excluded, and the figures of these. */
void
ProjectMap(const ColonPair &         pair,
           const CorrectedWarp &     corrected,
           double                    greatestDilatation,
           SupineProneRegistration & registration);
} // namespace itk

#endif
