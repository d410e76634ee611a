#ifndef shapetonRegistrationDocument_h
#define shapetonRegistrationDocument_h

#include "shapetonRegistrationResults.h"

namespace shapeton
{
/** Creates registration.json from otherwise complete results. \param frame errors of the frame from flexures and
 * taeniae; empty if there are no points. */
Json
DocumentOf(const SupineProneRegistration & registration,
           const RegistrationResults &     results,
           const RegistrationErrors &      frame);
} // namespace shapeton

#endif
