#ifndef shapetonRegistrationDocument_h
#define shapetonRegistrationDocument_h

#include "shapetonRegistrationResults.h"

namespace shapeton
{
/** registration.json of results whose other members are set. \param frame errors of the frame of flexures and taeniae,
 * empty without points. */
Json
DocumentOf(const SupineProneRegistration & registration,
           const RegistrationResults &     results,
           const RegistrationErrors &      frame);
} // namespace shapeton

#endif
