#ifndef shapetonPictureMaps_h
#define shapetonPictureMaps_h

#include "shapetonSvgPanel.h"

namespace shapeton
{
/** An orthonormal frame; z looks at the reader. */
struct Frame
{
  Place x;
  Place y;
  Place z;
};

Frame
FrameOf(const Place & z);

/** The half of the sphere that looks at the reader. */
PictureMap
Orthographic(const Frame & frame);

/** From the pole -z of the frame; seen as from outside the sphere. */
PictureMap
Stereographic(const Frame & frame);

/** The plane, or the disk of Poincare, as it is. */
PictureMap
Flat(bool isStraight);

/** The disk of Klein. */
PictureMap
Klein();
} // namespace shapeton

#endif
