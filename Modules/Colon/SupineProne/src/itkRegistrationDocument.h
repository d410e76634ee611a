#ifndef itkRegistrationDocument_h
#define itkRegistrationDocument_h

#include "itkRegistrationResults.h"

namespace itk
{
/** registration.json of results whose other members are there. \param frame errors of the frame of flexures and
 * taeniae, empty without points. */
Json
DocumentOf(const SupineProneRegistration & registration,
           const RegistrationResults &     results,
           const RegistrationErrors &      frame);
} // namespace itk

#endif
