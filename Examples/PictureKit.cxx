// Renders a surface without a display, colored by height, with a color bar, orientation letters and a scale bar.
// Usage: ExamplePictureKit SURFACE PICTURE.png
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceRendering.h"

#include "itkImageRegionConstIterator.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " SURFACE PICTURE.png\n";
    return 2;
  }
  const shapeton::Surface surface = shapeton::ReadSurface(argv[1]);
  const Eigen::VectorXd   height = surface.mesh.V.col(2);
  shapeton::ColorScale    scale;
  scale.title = "z [mm]";
  scale.lower = height.minCoeff();
  scale.upper = height.maxCoeff();

  shapeton::SurfaceScene scene;
  shapeton::SurfaceActor actor;
  actor.surface = &surface.mesh;
  actor.vertexColors = shapeton::ColorsOf(height.data(), height.size(), scale);
  scene.surfaces.push_back(actor);
  shapeton::SurfaceRenderingOptions options;
  options.azimuth = 30.0; // degrees, from the front to the left
  options.elevation = 40.0;
  options.colorBar = scale;
  const auto picture = shapeton::RenderSurfaces(scene, options);
  shapeton::WritePng(picture, argv[2]);

  const auto   region = picture->GetLargestPossibleRegion();
  const auto   background = picture->GetPixel(region.GetIndex());
  unsigned int drawn = 0;
  for (itk::ImageRegionConstIterator<shapeton::Picture> pixel(picture, region); !pixel.IsAtEnd(); ++pixel)
  {
    drawn += pixel.Get() != background;
  }
  std::cout << region.GetSize()[0] << " x " << region.GetSize()[1] << " pixels, "
            << 100 * drawn / region.GetNumberOfPixels() << " % of them drawn\n";
}
