// Repairs a surface, simplifies it to 600 faces and writes it for 3D Slicer.
// Usage: ExampleSurfaceMesh SURFACE OUTPUT.vtp
#include "itkSurfaceQuality.h"
#include "itkSurfaceReader.h"
#include "itkSurfaceRepair.h"
#include "itkSurfaceSimplification.h"
#include "itkSurfaceWriter.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " SURFACE OUTPUT.vtp\n";
    return 2;
  }
  const itk::Surface                surface = itk::ReadSurface(argv[1]);
  const itk::SurfaceMesh            repaired = itk::RepairSurface(surface.mesh);
  itk::SurfaceSimplificationOptions options;
  options.targetFaces = 600;
  const itk::SurfaceMesh    simple = itk::SimplifySurface(repaired, options);
  const itk::SurfaceQuality quality = itk::InspectSurface(simple);
  itk::WriteSurface(simple, argv[2]);
  std::cout << repaired.NumberOfFaces() << " faces become " << quality.faces << ", genus " << quality.genus.value_or(-1)
            << ", smallest angle " << quality.smallestAngle.minimum << " degrees\n";
}
