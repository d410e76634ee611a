// Repairs a surface, simplifies it to 600 faces and writes it for 3D Slicer.
// Usage: ExampleSurfaceMesh SURFACE OUTPUT.vtp
#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceRepair.h"
#include "shapetonSurfaceSimplification.h"
#include "shapetonSurfaceWriter.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " SURFACE OUTPUT.vtp\n";
    return 2;
  }
  const shapeton::Surface                 surface = shapeton::ReadSurface(argv[1]);
  const shapeton::SurfaceMesh             repaired = shapeton::RepairSurface(surface.mesh);
  shapeton::SurfaceSimplificationSettings options;
  options.faces = 600;
  const shapeton::SurfaceMesh    simple = shapeton::SimplifySurface(repaired, options);
  const shapeton::SurfaceQuality quality = shapeton::InspectSurface(simple);
  shapeton::WriteSurface(simple, argv[2]);
  std::cout << repaired.NumberOfFaces() << " faces become " << quality.faces << ", genus " << quality.genus.value_or(-1)
            << ", smallest angle " << quality.smallestAngle.minimum << " degrees\n";
}
