// Hands a volume to VTK: voxels, spacing, origin and direction cosines come along.
// Usage: ExampleVTKGlue VOLUME
#include "itkVTKImageBridge.h"
#include "itkVolumeReader.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " VOLUME\n";
    return 2;
  }
  const itk::Volume volume = itk::ReadVolume(argv[1]);
  const auto        image = itk::ImageToVTK(volume.image.GetPointer());
  double            position[3];
  image->TransformIndexToPhysicalPoint(10, 20, 5, position);
  std::cout << "the voxel (10, 20, 5) lies at (" << position[0] << ", " << position[1] << ", " << position[2]
            << ") mm and holds " << image->GetScalarComponentAsDouble(10, 20, 5, 0) << '\n';
}
