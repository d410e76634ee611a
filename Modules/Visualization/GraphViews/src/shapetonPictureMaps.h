#ifndef shapetonPictureMaps_h
#define shapetonPictureMaps_h

#include "shapetonSvgPanel.h"

namespace shapeton
{
/** An orthonormal frame; z points to the viewer. */
struct Frame
{
  Place x;
  Place y;
  Place z;
};

Frame
FrameOf(const Place & z);

/** Turned about z by an angle from x to y. */
Frame
Turned(const Frame & frame, double angle);

/** The hemisphere facing the viewer. */
PictureMap
Orthographic(const Frame & frame);

/** Stereographic projection from the pole -z of the frame, as seen from outside the sphere. */
PictureMap
Stereographic(const Frame & frame);

/** The plane, or the Poincare disk, unchanged. */
PictureMap
Flat(bool isStraight);

/** The Klein disk. */
PictureMap
Klein();
} // namespace shapeton

#endif
