// Writes a volume with a bright cube, reads it, and tells the cube from the background by its heat.
#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonVolumeReader.h"
#include "shapetonVolumeWriter.h"

#include <cstdlib>
#include <iostream>

using ImageType = itk::Image<float, 3>;

static ImageType::Pointer
MakeCube()
{
  const double spacing[] = { 0.5, 0.5, 2.0 };
  auto         image = ImageType::New();
  image->SetRegions(ImageType::SizeType{ { 24, 24, 24 } });
  image->SetSpacing(spacing);
  image->Allocate(true);
  ImageType::IndexType index;
  for (index[2] = 9; index[2] < 15; ++index[2])
  {
    for (index[1] = 9; index[1] < 15; ++index[1])
    {
      for (index[0] = 9; index[0] < 15; ++index[0])
      {
        image->SetPixel(index, 1000.0f);
      }
    }
  }
  return image;
}

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: Consumer FILE.nrrd" << std::endl;
    return EXIT_FAILURE;
  }
  shapeton::WriteVolume(MakeCube().GetPointer(), argv[1]);
  const shapeton::Volume volume = shapeton::ReadVolume(argv[1]);

  auto diffusion = shapeton::CumulativeHeatDiffusionImageFilter<ImageType>::New();
  diffusion->SetInput(volume.image);
  diffusion->SetTimeSteps(1000);
  diffusion->Update();

  const ImageType * heat = diffusion->GetOutput();
  const float       cube = heat->GetPixel({ { 12, 12, 12 } });
  const float       background = heat->GetPixel({ { 2, 2, 2 } });
  std::cout << "heat of the cube " << cube << ", of the background " << background << std::endl;
  const bool isRight = cube > 0.0f && cube <= 1.0f && cube > 10.0f * background;
  return isRight && heat->GetSpacing() == volume.image->GetSpacing() ? EXIT_SUCCESS : EXIT_FAILURE;
}
