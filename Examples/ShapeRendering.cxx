// Draws the heat histogram of a volume: time downwards, one line for each object that stays apart.
// Usage: ExampleShapeRendering VOLUME OUTPUT.png
#include "itkCumulativeHeatDiffusionImageFilter.h"
#include "itkHeatHistogramPicture.h"
#include "itkVolumeReader.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " VOLUME OUTPUT.png\n";
    return 2;
  }
  const itk::Volume volume = itk::ReadVolume(argv[1]);
  const auto        diffusion = itk::CumulativeHeatDiffusionImageFilter<itk::Volume::ImageType>::New();
  diffusion->SetInput(volume.image);
  diffusion->SetTimeSteps(4096);
  diffusion->SetHistogramSteps({ 1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096 });
  diffusion->Update();

  itk::HeatHistogramPictureOptions options;
  options.markedTimeSteps = { 16, 512 };
  itk::WritePng(itk::DrawHeatHistogram(diffusion->GetResult().histogram, options), argv[2]);
}
