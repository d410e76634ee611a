// Diffuses heat with automatic parameters, and lists its objects. Usage: ExampleHeatObjects VOLUME
#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonHeatObjects.h"
#include "shapetonHeatParameterChoice.h"
#include "shapetonVolumeReader.h"

#include <algorithm>
#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " VOLUME\n";
    return 2;
  }
  using ImageType = shapeton::Volume::ImageType;
  const shapeton::Volume     volume = shapeton::ReadVolume(argv[1]);
  const shapeton::VolumeView view(volume.image.GetPointer());
  const auto                 diffusion = shapeton::CumulativeHeatDiffusionImageFilter<ImageType>::New();
  diffusion->SetInput(volume.image);
  diffusion->UseParameters(shapeton::ChooseHeatParameters(view, diffusion->GetOptions()));
  diffusion->Update();
  const auto list = shapeton::FindHeatObjects(diffusion->GetOutput());
  std::cout << list.objects.size() << " objects\n";
  for (std::size_t i = 0; i < list.objects.size(); ++i)
  {
    const auto & object = list.objects[i];
    const auto   mask = shapeton::MaskOfObject(list, static_cast<int>(i + 1)); // as a click
    std::cout << object.volume << " mm^3 at " << object.center << ", in object " << object.parent << ", "
              << std::count(mask->GetBufferPointer(), mask->GetBufferPointer() + view.NumberOfVoxels(), 1)
              << " voxels\n";
  }
}
