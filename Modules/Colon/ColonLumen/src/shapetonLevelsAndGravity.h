#ifndef shapetonLevelsAndGravity_h
#define shapetonLevelsAndGravity_h

#include "shapetonColonLumenSegmentation.h"
#include "shapetonColonSearch.h"

namespace shapeton
{
/** Fills in which way fluid falls and the levels under the candidates: along the direction that the position of the
 * patient says, else the one with by far the most flat levels, else supine. Warns where the position contradicts the
 * levels, and where nothing is known. */
void
FindGravity(const std::string & patientPosition, ColonEvidence & evidence, ColonLumen & lumen);
} // namespace shapeton

#endif
