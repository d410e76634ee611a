// Runs cumulative heat diffusion until the heat is uniform in each closed object; the heat depends on shape and size.
// Usage: ExampleHeat VOLUME
#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonVolumeReader.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " VOLUME\n";
    return 2;
  }
  const shapeton::Volume volume = shapeton::ReadVolume(argv[1]);
  const auto             diffusion = shapeton::CumulativeHeatDiffusionImageFilter<shapeton::Volume::ImageType>::New();
  diffusion->SetInput(volume.image);
  diffusion->SetP(7.0);
  diffusion->SetTimeSteps(100000);
  diffusion->WantComponentsOn();
  diffusion->Update(); // diffusion->GetOutput() is the heat
  for (const auto & component : diffusion->GetResult().components)
  {
    std::cout << component.voxels << " voxels: heat " << component.convergedHeat << '\n';
  }
}
