#ifndef shapetonIlealCaliber_h
#define shapetonIlealCaliber_h

namespace shapeton
{
/** Maximum radius (mm) of the slit of an open ileocecal valve; chosen: half the opening of a gas-filled one. */
constexpr double OpenValve = 4.0;
/** Maximum radius (mm) of a distended ileum: small bowel of more than 30 mm is dilated. */
constexpr double DistendedIleum = 15.0;
} // namespace shapeton

#endif
