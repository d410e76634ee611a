// Reads a volume with ITK, removes noise with ITK's median filter, runs Shapeton's heat diffusion, writes the heat with
// ITK. Usage: MedianHeat INPUT OUTPUT [RADIUS]; RADIUS of the median in voxels, default 1
#include "shapetonCumulativeHeatDiffusionImageFilter.h"

#include "itkImageFileReader.h"
#include "itkImageFileWriter.h"
#include "itkMedianImageFilter.h"

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

namespace
{
using ImageType = itk::Image<float, 3>;

void
Diffuse(const std::string & input, const std::string & output, unsigned long radius)
{
  const auto median = itk::MedianImageFilter<ImageType, ImageType>::New();
  median->SetInput(itk::ReadImage<ImageType>(input));
  median->SetRadius(radius);

  const auto diffusion = shapeton::CumulativeHeatDiffusionImageFilter<ImageType>::New();
  diffusion->SetInput(median->GetOutput());
  diffusion->SetTimeSteps(1000);

  const auto writer = itk::ImageFileWriter<ImageType>::New();
  writer->SetInput(diffusion->GetOutput());
  writer->SetFileName(output);
  writer->Update();
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc < 3 || argc > 4)
  {
    std::cerr << "Usage: " << argv[0] << " INPUT OUTPUT [RADIUS]\n";
    return 2;
  }
  try
  {
    Diffuse(argv[1], argv[2], argc == 4 ? std::stoul(argv[3]) : 1);
  }
  catch (const std::exception & error) // including ITK's exceptions
  {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
