#ifndef shapetonCurveTubes_h
#define shapetonCurveTubes_h

#include "shapetonSurfaceRendering.h"

namespace shapeton
{
/** A mesh and a colour for each of its vertices. */
struct ColoredMesh
{
  SurfaceMesh           mesh;
  std::vector<RGBColor> colors;
};

/** The curves as tubes with round ends. */
ColoredMesh
TubesAround(const CurveActor & actor);

ColoredMesh
BallsAt(const std::vector<MarkerActor> & markers);
} // namespace shapeton

#endif
