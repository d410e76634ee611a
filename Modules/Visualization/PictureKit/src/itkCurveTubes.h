#ifndef itkCurveTubes_h
#define itkCurveTubes_h

#include "itkSurfaceRendering.h"

namespace itk
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
} // namespace itk

#endif
