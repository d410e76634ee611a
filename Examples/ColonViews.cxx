// Draws the wall of a tube as a flat picture colored by curvature, with a mark.
// Usage: ExampleColonViews TUBE PICTURE.png
#include "shapetonColonFlattening.h"
#include "shapetonFlatColonPictures.h"
#include "shapetonSurfaceReader.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " TUBE PICTURE.png\n";
    return 2;
  }
  const shapeton::Surface         tube = shapeton::ReadSurface(argv[1]);
  const shapeton::ColonFlattening flattening = shapeton::FlattenColon(tube.mesh, argv[1]);

  const shapeton::FlatColon flat(flattening.map.flat);
  shapeton::FlatColonParts  parts;
  parts.flat = &flat;
  shapeton::FlatAnnotation mark;
  mark.text = "a vertex";
  mark.point = tube.mesh.V.row(600);
  parts.annotations.push_back(mark);
  const shapeton::FlatColonPictures pictures(parts, 1.0); // pixels of 1 mm
  const auto                        picture = pictures.Draw(shapeton::FlatColoring::Curvature, "A tube");
  shapeton::WritePng(picture, argv[2]);

  const auto size = picture->GetLargestPossibleRegion().GetSize();
  std::cout << "a map of " << pictures.Grid().Columns() << " x " << pictures.Grid().Rows() << " pixels in a picture of "
            << size[0] << " x " << size[1] << '\n';
}
