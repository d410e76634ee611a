// Draws the heat histogram of a volume: time downwards, one line for each separate object.
// Usage: ExampleHeatViews VOLUME OUTPUT.png
#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonHeatHistogramPicture.h"
#include "shapetonVolumeReader.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " VOLUME OUTPUT.png\n";
    return 2;
  }
  const shapeton::Volume volume = shapeton::ReadVolume(argv[1]);
  const auto             diffusion = shapeton::CumulativeHeatDiffusionImageFilter<shapeton::Volume::ImageType>::New();
  diffusion->SetInput(volume.image);
  diffusion->SetTimeSteps(4096);
  diffusion->SetHistogramSteps({ 1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096 });
  diffusion->Update();

  const shapeton::HeatHistogram &       histogram = diffusion->GetResult().histogram;
  shapeton::HeatHistogramPictureOptions options;
  options.markedTimeSteps = { 16, 512 };
  const auto picture = shapeton::DrawHeatHistogram(histogram, options);
  shapeton::WritePng(picture, argv[2]);
  std::cout << histogram.GetNumberOfRows() << " rows in a picture of " << picture->GetLargestPossibleRegion().GetSize()
            << " pixels\n";
}
