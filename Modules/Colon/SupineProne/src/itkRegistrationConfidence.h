#ifndef itkRegistrationConfidence_h
#define itkRegistrationConfidence_h

#include "itkSupineProneRegistration.h"

namespace itk
{
/** Fills in all of it but energies and margin, which it uses. */
void
JudgeRegistration(const ColonPosition & source, const ColonPosition & target, SupineProneRegistration & registration);
} // namespace itk

#endif
