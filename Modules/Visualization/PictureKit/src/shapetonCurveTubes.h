#ifndef shapetonCurveTubes_h
#define shapetonCurveTubes_h

#include "shapetonSurfaceRendering.h"

namespace shapeton
{
/** A mesh with a color per vertex. */
struct ColoredMesh
{
  SurfaceMesh           mesh;
  std::vector<RGBColor> colors;
};

/** The curves as tubes with round caps. */
ColoredMesh
TubesAround(const CurveActor & actor);

ColoredMesh
BallsAt(const std::vector<MarkerActor> & markers);
} // namespace shapeton

#endif
