#ifndef shapetonRegisteredTestPair_h
#define shapetonRegisteredTestPair_h

#include "shapetonRegistrationReport.h"
#include "shapetonTestColons.h"

namespace tubecolons
{
inline const Movement movement{ 0.37, 8.0 };

/** Two positions of a patient and their registration. */
struct Pair
{
  shapeton::RegistrationParts
  Parts() const
  {
    return { &supine, &prone, &results };
  }

  shapeton::ColonPositionFiles      supine = MakeExamination("supine", 1, {});
  shapeton::ColonPositionFiles      prone = MakeExamination("prone", 1, movement);
  shapeton::SupineProneRegistration registration = shapeton::RegisterColonPositions(supine.position, prone.position);
  shapeton::RegistrationResults     results =
    shapeton::MakeRegistrationResults(supine, prone, registration, KnownPoints(movement));
};

/** Registered once for all tests. */
inline const Pair &
TestPair()
{
  static const Pair pair;
  return pair;
}
} // namespace tubecolons

#endif
