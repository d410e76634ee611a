#ifndef shapetonRegistrationConfidence_h
#define shapetonRegistrationConfidence_h

#include "shapetonColonPair.h"
#include "shapetonSupineProneRegistration.h"

namespace shapeton
{
/** Sets the confidence based on its energies and margin, and the local confidence. */
void
JudgeRegistration(const ColonPair & pair, SupineProneRegistration & registration);
} // namespace shapeton

#endif
