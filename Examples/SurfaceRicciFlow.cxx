// Finds the flat metric of a torus by discrete Ricci flow and prints its conformal type tau.
// Usage: ExampleSurfaceRicciFlow TORUS FLAT.vtp
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceRicciFlow.h"
#include "shapetonSurfaceWriter.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " TORUS FLAT.vtp\n";
    return 2;
  }
  const shapeton::Surface          surface = shapeton::ReadSurface(argv[1]);
  const shapeton::SurfaceRicciFlow flow = shapeton::FlowSurface(surface.mesh, {}, argv[1]);
  shapeton::WriteSurface(flow.flat, argv[2]); // in space, with the point array uv (mm)

  std::cout << "genus " << flow.genus << ", tau " << flow.tau.real() << " + " << flow.tau.imag() << " i, " << flow.steps
            << " steps, curvature error " << flow.residual << '\n';
}
