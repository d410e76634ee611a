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
  /** As the dissertation (4.3): folds are matched once about the frame of flexures and taeniae, and the map is forced
   * through middle and ends of all of them; the thin plate stands for its harmonic map. Triangles may be turned over.
   */
  HardConstraints
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
