// Diffuses heat in each intensity window that shows objects, and lists the objects of all windows. Usage:
// ExampleHeatObjects VOLUME
#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonObjectParameters.h"
#include "shapetonVolumeReader.h"
#include "shapetonWindowObjects.h"

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
  const shapeton::Volume          volume = shapeton::ReadVolume(argv[1]);
  const shapeton::VolumeView      view(volume.image.GetPointer());
  const auto                      windows = shapeton::ChooseObjectWindows(view);
  std::vector<ImageType::Pointer> heats;
  for (const auto & window : windows)
  {
    const auto diffusion = shapeton::CumulativeHeatDiffusionImageFilter<ImageType>::New();
    diffusion->SetInput(volume.image);
    diffusion->UseParameters(window);
    diffusion->Update();
    heats.push_back(diffusion->GetOutput());
  }
  const auto list = shapeton::FindWindowObjects({ heats.begin(), heats.end() });
  std::cout << windows.size() << " windows, " << list.objects.size() << " objects\n";
  for (std::size_t i = 0; i < list.objects.size(); ++i)
  {
    const auto & object = list.objects[i];
    const auto   mask = shapeton::MaskOfObject(list, static_cast<int>(i + 1)); // as a click
    std::cout << object.volume << " mm^3 at " << object.center << ", window " << object.time + 1 << ", in object "
              << object.parent << ", "
              << std::count(mask->GetBufferPointer(), mask->GetBufferPointer() + view.NumberOfVoxels(), 1)
              << " voxels\n";
  }
}
