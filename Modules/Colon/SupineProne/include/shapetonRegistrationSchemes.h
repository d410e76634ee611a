#ifndef shapetonRegistrationSchemes_h
#define shapetonRegistrationSchemes_h

#include "shapetonSupineProneRegistration.h"

namespace shapeton
{
/** Simpler registration methods, for comparison. \ingroup ShapetonSupineProne */
enum class RegistrationScheme
{
  /** Flat maps scaled to the same length and rotated by the single angle at which the fold pictures agree best. */
  Rectangles,
  /** Like Rectangles, but with proportional distances along the centerlines. */
  Centerline,
  /** SupineProneRegistration::frame, from flexures and taeniae. */
  Landmarks,
  /** SupineProneRegistration::warp, before fold matching. */
  Warping,
  /** The quasi-conformal map of SupineProneMap::Published, but constrained only by the ends of the colon and the
   * consistent fold pairs of the registration. */
  QuasiConformal
};

/** The map of a scheme for a pair registered by RegisterColonPositions(); reuses frame and warp of `registration`.
 * \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT CylinderMap
MapOfScheme(RegistrationScheme              scheme,
            const ColonPosition &           source,
            const ColonPosition &           target,
            const SupineProneRegistration & registration);
} // namespace shapeton

#endif
