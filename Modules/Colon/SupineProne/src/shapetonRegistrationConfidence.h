#ifndef shapetonRegistrationConfidence_h
#define shapetonRegistrationConfidence_h

#include "shapetonSupineProneRegistration.h"

namespace shapeton
{
/** Fills in all of it but energies and margin, which it uses. */
void
JudgeRegistration(const ColonPosition & source, const ColonPosition & target, SupineProneRegistration & registration);
} // namespace shapeton

#endif
