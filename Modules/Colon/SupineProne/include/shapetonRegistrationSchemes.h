#ifndef shapetonRegistrationSchemes_h
#define shapetonRegistrationSchemes_h

#include "shapetonSupineProneRegistration.h"

namespace shapeton
{
/** Simpler registration methods, for comparison. \ingroup ShapetonSupineProne */
enum class RegistrationScheme
{
  /** Flat maps stretched to the same length, with the single rotation in which their fold pictures agree best. */
  Rectangles,
  /** As Rectangles, with proportional distances along the centerlines. */
  Centerline,
  /** Flexures and taeniae: SupineProneRegistration::frame. */
  Landmarks,
  /** The warping before fold matching: SupineProneRegistration::warp. */
  Warping,
  /** SupineProneMap::Published. */
  Published,
  /** The quasi-conformal map of Published, but only through the ends of the colon and the folds that the registration
   * has matched and the map follows. */
  QuasiConformal
};

/** The map of a scheme for a pair registered by RegisterColonPositions(); frame and warp are taken from `registration`.
 * \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT CylinderMap
MapOfScheme(RegistrationScheme              scheme,
            const ColonPosition &           source,
            const ColonPosition &           target,
            const SupineProneRegistration & registration);
} // namespace shapeton

#endif
