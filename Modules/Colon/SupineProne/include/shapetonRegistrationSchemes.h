#ifndef shapetonRegistrationSchemes_h
#define shapetonRegistrationSchemes_h

#include "shapetonSupineProneRegistration.h"

namespace shapeton
{
/** Simpler ways to register, for comparison. \ingroup SupineProne */
enum class RegistrationScheme
{
  /** The flat maps, stretched to the same length, with the one rotation in which their pictures of folds agree best. */
  Rectangles,
  /** The same with proportional distances along the centrelines. */
  Centreline,
  /** Flexures and taeniae: SupineProneRegistration::frame. */
  Landmarks,
  /** The warping without matched folds: SupineProneRegistration::warp. */
  Warping,
  /** SupineProneMap::Published. */
  Published,
  /** The quasi-conformal map of Published, but through the folds that the registration has matched and the map follows,
   * and the ends of the colon alone. */
  QuasiConformal
};

/** The map that a scheme gives for a pair that RegisterColonPositions() has registered; frame and warp are taken from
 * `registration`. \ingroup SupineProne */
SupineProne_EXPORT CylinderMap
MapOfScheme(RegistrationScheme              scheme,
            const ColonPosition &           source,
            const ColonPosition &           target,
            const SupineProneRegistration & registration);
} // namespace shapeton

#endif
