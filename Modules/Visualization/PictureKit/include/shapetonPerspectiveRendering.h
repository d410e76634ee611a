#ifndef shapetonPerspectiveRendering_h
#define shapetonPerspectiveRendering_h

#include "shapetonSurfaceRendering.h"

namespace shapeton
{
/** A perspective camera, for example of an endoscope. \ingroup ShapetonPictureKit */
struct PerspectiveCamera
{
  /** LPS, mm. */
  Eigen::Vector3d eye{ Eigen::Vector3d::Zero() };
  /** Point shown at the center of the picture. */
  Eigen::Vector3d focus{ Eigen::Vector3d::UnitZ() };
  /** Up direction; its component perpendicular to the view direction points upwards in the picture. */
  Eigen::Vector3d up{ Eigen::Vector3d::UnitZ() };
  /** Horizontal field of view in degrees, above 0 and below 170. */
  double fieldOfView{ 90.0 };
  /** Pixels. */
  unsigned int width{ 480 };
  unsigned int height{ 360 };
  /** mm; faces with a corner nearer than this are not drawn. */
  double nearest{ 1.0 };
  /** Distance (mm) at which the light has half its strength. Light decreases with the square of the distance. */
  double lightReach{ 60.0 };
};

/** Renders a surface in perspective, lit from next to the eye. Like RenderSurfaces(), uses a depth buffer and 3 x 3
 * samples per pixel, and yields the same bytes for any number of threads. `vertexColors` has one color per vertex.
 * Throws std::invalid_argument for numbers out of range, a view direction that is zero or parallel to `up`, and a wrong
 * number of colors. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT Picture::Pointer
                          RenderPerspective(const SurfaceMesh &           surface,
                                            const std::vector<RGBColor> & vertexColors,
                                            const PerspectiveCamera &     camera);

/** Picture position of a point, in pixels; NaN behind the eye. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT Eigen::Vector2d
                          ProjectPoint(const Eigen::Vector3d & point, const PerspectiveCamera & camera);
} // namespace shapeton

#endif
