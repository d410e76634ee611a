#ifndef shapetonRefinedPattern_h
#define shapetonRefinedPattern_h

#include "shapetonConformalMapPicture.h"

namespace shapeton
{
/** A surface with a colour for each face. */
struct ColoredSurface
{
  SurfaceMesh           mesh;
  std::vector<RGBColor> faceColors;
};

/** The surface, its faces cut in four until there are enough of them to show a pattern, each in the colour that it has
 * at its centre. */
ColoredSurface
RefineForPattern(const SurfaceMesh & shape, const Eigen::MatrixX2d & uv, const PlanePattern & pattern);
} // namespace shapeton

#endif
