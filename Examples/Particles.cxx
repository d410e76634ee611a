// Shapeton diffusion with an observer.
// Usage: ExampleParticles VOLUME
#include "shapetonParticleDiffusionImageFilter.h"
#include "shapetonVolumeReader.h"

#include "itkCommand.h"

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
  const auto             diffusion = shapeton::ParticleDiffusionImageFilter<shapeton::Volume::ImageType>::New();
  diffusion->SetInput(volume.image);
  diffusion->SetShapetons(20000);
  diffusion->SetDistance(0.03);
  diffusion->SetTimeSteps(500);
  diffusion->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
    const auto & measures = diffusion->GetMeasures(); // diffusion->GetOutput() contains the visits so far
    std::cout << "step " << measures.step << ": coverage " << measures.GetCoverage() << '\n';
  });
  diffusion->Update();
  std::cout << "most visits: " << diffusion->GetMeasures().maximumVisits << '\n';
}
