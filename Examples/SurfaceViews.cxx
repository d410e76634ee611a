// Maps a tube to an annulus, and draws both with the checkerboard of the plane: squares, because the map is
// conformal. Usage: ExampleSurfaceViews TUBE PICTURE.png
#include "shapetonConformalMapPicture.h"
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
  const shapeton::Surface        tube = shapeton::ReadSurface(argv[1]);
  shapeton::ConformalMapSettings options;
  options.domain = shapeton::ConformalDomain::Annulus;
  const shapeton::ConformalMap map = shapeton::MapConformally(tube.mesh, options, argv[1]);

  shapeton::ConformalMapPictureOptions pictureOptions;
  pictureOptions.checks = 24; // around the annulus
  const auto picture = shapeton::DrawConformalMap(map, pictureOptions);
  shapeton::WritePng(picture, argv[2]);
  std::cout << map.loops.size() << " boundaries, median dilatation " << map.dilatation.median << ", moduli agree to "
            << 100.0 * map.ModulusGap() << " %, picture of " << picture->GetLargestPossibleRegion().GetSize()
            << " pixels\n";
}
