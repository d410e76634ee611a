#ifndef shapetonRefinedPattern_h
#define shapetonRefinedPattern_h

#include "shapetonConformalMapPicture.h"

namespace shapeton
{
/** A surface with a color per face. */
struct ColoredSurface
{
  SurfaceMesh           mesh;
  std::vector<RGBColor> faceColors;
};

/** The surface with faces subdivided 1-to-4 until they resolve the pattern, each in the pattern's color at its
 * center. */
ColoredSurface
RefineForPattern(const SurfaceMesh & shape, const Eigen::MatrixX2d & uv, const PlanePattern & pattern);
} // namespace shapeton

#endif
