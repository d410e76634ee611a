// Reads a surface, measures it with a VTK filter, and converts it to RAS and back.
// Usage: ExampleVTKData SURFACE
#include "shapetonPolyDataAdapter.h"
#include "shapetonSurfaceReader.h"

#include <vtkMassProperties.h>
#include <vtkNew.h>

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " SURFACE\n";
    return 2;
  }
  const shapeton::SurfaceMesh mesh = shapeton::ReadSurface(argv[1]).mesh;
  vtkNew<vtkMassProperties>   measure;
  measure->SetInputData(shapeton::PolyDataOf(mesh));
  const auto                  turned = shapeton::PolyDataOf(mesh, shapeton::PatientSpace::RAS);
  const shapeton::SurfaceMesh back = shapeton::SurfaceOf(*turned); // its field data state RAS
  std::cout << "a surface of " << measure->GetSurfaceArea() << " mm^2; after conversion from RAS it is "
            << (back.V == mesh.V ? "unchanged" : "changed") << '\n';
}
