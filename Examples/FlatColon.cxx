// Maps a point in space to its pixel on the flat map of a tube and back; writes the point in space of every pixel.
// Usage: ExampleFlatColon TUBE COORDINATES.nrrd
#include "shapetonColonFlattening.h"
#include "shapetonFlatColon.h"
#include "shapetonFlatColonLocator.h"
#include "shapetonFlatCoordinateMap.h"
#include "shapetonSurfaceReader.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " TUBE COORDINATES.nrrd\n";
    return 2;
  }
  const shapeton::Surface         tube = shapeton::ReadSurface(argv[1]);
  const shapeton::ColonFlattening flattening = shapeton::FlattenColon(tube.mesh, argv[1]);
  const shapeton::FlatColon       flat(flattening.map.flat);
  const shapeton::FlatColonGrid & grid = flat.Grid(); // pixels of 1 mm
  shapeton::WriteFlatCoordinateMap(grid, argv[2]);

  const Eigen::Vector3d     point = tube.mesh.V.row(600).transpose();
  const shapeton::FlatPlace place = shapeton::FlatColonLocator(grid).Find(point);
  const double              away = (grid.PointOfPixel(place.pixel.column, place.pixel.row) - point).norm();
  std::cout << grid.Columns() << " x " << grid.Rows() << " pixels, " << grid.UncoveredPixels()
            << " without a face; the point is in pixel " << place.pixel.column << ", " << place.pixel.row
            << ", whose center is " << away << " mm away\n";
}
