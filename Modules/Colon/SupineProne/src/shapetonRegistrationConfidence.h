#ifndef shapetonRegistrationConfidence_h
#define shapetonRegistrationConfidence_h

#include "shapetonSupineProneRegistration.h"

namespace shapeton
{
/** Sets the confidence from its energies and margin. */
void
JudgeRegistration(const ColonPosition & source, const ColonPosition & target, SupineProneRegistration & registration);
} // namespace shapeton

#endif
