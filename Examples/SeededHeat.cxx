// Labels a volume from one seed inside an object and one in a corner, and prints the volume of the object.
// Usage: ExampleSeededHeat VOLUME X Y Z, the index of the seed
#include "shapetonMappedImage.h"
#include "shapetonSeededHeatSegmentationImageFilter.h"
#include "shapetonVolumeReader.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 5)
  {
    std::cerr << "Usage: " << argv[0] << " VOLUME X Y Z\n";
    return 2;
  }
  const shapeton::Volume volume = shapeton::ReadVolume(argv[1]);
  const auto             filter = shapeton::SeededHeatSegmentationImageFilter<shapeton::Volume::ImageType>::New();
  const auto             seeds = shapeton::NewImageOn<itk::Image<unsigned short, 3>>(volume.image, true);
  seeds->SetPixel({ { 0, 0, 0 } }, 1);
  seeds->SetPixel({ { std::atoi(argv[2]), std::atoi(argv[3]), std::atoi(argv[4]) } }, 2);
  filter->SetInput(volume.image);
  filter->SetSeeds(seeds);
  filter->Update();
  const auto * const begin = filter->GetOutput()->GetBufferPointer();
  const auto         voxels = std::count(begin, begin + seeds->GetLargestPossibleRegion().GetNumberOfPixels(), 2);
  std::cout << voxels << " voxels belong to the seed; " << filter->GetIterations() << " iterations\n";
}
