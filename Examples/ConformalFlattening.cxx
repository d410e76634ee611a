// Removes the handles of a tube, maps it conformally to a rectangle in the heat diffusion metric, and prints the
// quality.
// Usage: ExampleConformalFlattening TUBE FLAT.vtp
#include "shapetonColonFlattening.h"
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceWriter.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " TUBE FLAT.vtp\n";
    return 2;
  }
  const shapeton::Surface           tube = shapeton::ReadSurface(argv[1]);
  shapeton::ColonFlatteningSettings options; // automatic diffusion time
  options.topology = shapeton::SurfaceTopology::Denoised;
  const shapeton::ColonFlattening flattening = shapeton::FlattenColon(tube.mesh, argv[1], options);
  shapeton::WriteSurface(flattening.map.flat, argv[2]); // in space, with the point array uv (mm)

  const auto dilatation = shapeton::QuantilesOfDilatation(flattening.distortion);
  std::cout << "genus " << flattening.genusBefore << " becomes " << flattening.genusAfter << "; "
            << flattening.map.length << " x " << flattening.map.circumference << " mm, moduli agree to "
            << 100.0 * flattening.map.Gap() << " %, " << flattening.distortion.flips << " flips, median dilatation "
            << dilatation.median << '\n';
}
