// Reads a DICOM series with its geometry and writes it as one file.
// Usage: ExampleDicomSeries FOLDER OUTPUT.nrrd
#include "itkVolumeReader.h"
#include "itkVolumeWriter.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " FOLDER OUTPUT.nrrd\n";
    return 2;
  }
  const itk::Volume volume = itk::ReadVolume(argv[1]); // throws itk::InputError for an irregular series
  std::cout << volume.modality << ", " << volume.image->GetLargestPossibleRegion().GetSize() << " voxels of "
            << volume.image->GetSpacing() << " mm\n";
  itk::WriteVolume(volume.image.GetPointer(), argv[2], { { "source", volume.identity } });
}
