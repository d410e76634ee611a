#ifndef shapetonPerspectiveRendering_h
#define shapetonPerspectiveRendering_h

#include "shapetonSurfaceRendering.h"

namespace shapeton
{
/** An eye in space, as that of an endoscope. \ingroup PictureKit */
struct PerspectiveCamera
{
  /** LPS, mm. */
  Eigen::Vector3d eye{ Eigen::Vector3d::Zero() };
  /** What it looks at; lies in the middle of the picture. */
  Eigen::Vector3d focus{ Eigen::Vector3d::UnitZ() };
  /** Upwards in the picture, as far as it is across the direction of the look. */
  Eigen::Vector3d up{ Eigen::Vector3d::UnitZ() };
  /** Degrees across the width of the picture, above 0 and below 170. */
  double fieldOfView{ 90.0 };
  /** Pixels. */
  unsigned int width{ 480 };
  unsigned int height{ 360 };
  /** mm; faces with a corner nearer than this are not drawn. */
  double nearest{ 1.0 };
  /** mm; light falls to a half there and on with the square of the distance. */
  double lightReach{ 60.0 };
};

/** A picture of a surface in a perspective projection, lit from beside the eye. Drawn as RenderSurfaces() does: a depth
 * buffer, 3 x 3 samples for each pixel, the same bytes for any number of threads. `vertexColors` has one for each
 * vertex. Throws std::invalid_argument for numbers out of range, a look along `up` or from the focus, and colours that
 * do not match. \ingroup PictureKit */
PictureKit_EXPORT Picture::Pointer
                  RenderPerspective(const SurfaceMesh &           surface,
                                    const std::vector<RGBColor> & vertexColors,
                                    const PerspectiveCamera &     camera);

/** The place in the picture of a point, pixels; not numbers behind the eye. \ingroup PictureKit */
PictureKit_EXPORT Eigen::Vector2d
                  ProjectPoint(const Eigen::Vector3d & point, const PerspectiveCamera & camera);
} // namespace shapeton

#endif
