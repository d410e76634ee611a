// A tube as a flat picture: flatten it, look up where a point of it lies on the map, and paint it.
// Usage: ExampleFlatColon TUBE.off PICTURE.png
#include "itkColonFlattening.h"
#include "itkFlatColonLocator.h"
#include "itkFlatColonPictures.h"
#include "itkSurfaceReader.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " TUBE.off PICTURE.png\n";
    return 2;
  }
  const itk::Surface         tube = itk::ReadSurface(argv[1]);
  const itk::ColonFlattening flattening = itk::FlattenColon(tube.mesh, argv[1]);

  itk::FlatColonParts parts;
  parts.flat = &flattening.map.flat;
  itk::FlatAnnotation mark;
  mark.text = "a vertex";
  mark.point = tube.mesh.V.row(600);
  parts.annotations.push_back(mark);
  const itk::FlatColonPictures pictures(parts, 1.0); // pixels of 1 mm
  itk::WritePng(pictures.Draw(itk::FlatColoring::Curvature, "A tube"), argv[2]);

  const itk::FlatColonGrid & grid = pictures.Grid();
  const itk::FlatPixel       pixel = itk::FlatColonLocator(grid).Find(*mark.point).pixel;
  const double               away = (grid.PointOfPixel(pixel.column, pixel.row) - *mark.point).norm();
  std::cout << grid.Columns() << " x " << grid.Rows() << " pixels; the vertex lies in pixel " << pixel.column << ", "
            << pixel.row << ", whose middle is " << away << " mm away\n";
}
