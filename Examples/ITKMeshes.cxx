// Converts a surface with an array to an ITK mesh and back.
// Usage: ExampleITKMeshes SURFACE
#include "shapetonMeshAdapter.h"
#include "shapetonSurfaceReader.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " SURFACE\n";
    return 2;
  }
  shapeton::SurfaceMesh surface = shapeton::ReadSurface(argv[1]).mesh;
  surface.pointArrays.push_back({ "radius", surface.V.rowwise().norm() });
  const auto mesh = shapeton::PipelineMesh::New();
  shapeton::FillMesh(surface, *mesh);
  shapeton::PipelineMesh::PixelType values;
  mesh->GetPointData(0, &values);
  const shapeton::SurfaceMesh back = shapeton::SurfaceOf(*mesh);
  std::cout << mesh->GetNumberOfCells() << " cells; the first point has the radius " << values[0] << "; array \""
            << back.pointArrays.front().name << "\" is restored\n";
}
