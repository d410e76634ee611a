// Lists the objects of a heat volume, such as that of ExampleITKSeries. Usage: ExampleHeatObjects HEAT
#include "shapetonHeatObjects.h"
#include "shapetonVolumeReader.h"

#include <algorithm>
#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " HEAT\n";
    return 2;
  }
  const auto list = shapeton::FindHeatObjects(shapeton::ReadVolume(argv[1]).image);
  std::cout << list.objects.size() << " objects\n";
  for (std::size_t i = 0; i < list.objects.size(); ++i)
  {
    const auto & object = list.objects[i];
    const auto   mask = shapeton::MaskOfObject(list, static_cast<int>(i + 1)); // as a click
    std::cout << object.volume << " mm^3 at " << object.center << ", in object " << object.parent << ", "
              << std::count(mask->GetBufferPointer(), mask->GetBufferPointer() + mask->GetPixelContainer()->Size(), 1)
              << " voxels\n";
  }
}
