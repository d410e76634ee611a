// Reads a DICOM series with its geometry and writes it as one file.
// Usage: ExampleDicomSeries FOLDER OUTPUT.nrrd
#include "shapetonVolumeReader.h"
#include "shapetonVolumeWriter.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " FOLDER OUTPUT.nrrd\n";
    return 2;
  }
  const shapeton::Volume volume = shapeton::ReadVolume(argv[1]); // throws shapeton::InputError for an irregular series
  std::cout << volume.modality << ", " << volume.image->GetLargestPossibleRegion().GetSize() << " voxels of "
            << volume.image->GetSpacing() << " mm\n";
  shapeton::WriteVolume(volume.image.GetPointer(), argv[2], { { "source", volume.identity } });
}
