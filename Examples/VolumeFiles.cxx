// Writes a volume as NRRD, NIfTI and MetaImage, reads each back and compares grid and voxels.
// Usage: ExampleVolumeFiles FOLDER
#include "shapetonImageFile.h"
#include "shapetonImageGrid.h"
#include "shapetonVolumeWriter.h"

#include "itkImageRegionConstIterator.h"
#include "itkImageRegionIteratorWithIndex.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " FOLDER\n";
    return 2;
  }
  using ImageType = itk::Image<short, 3>;
  const auto   image = ImageType::New();
  const double spacing[3] = { 0.7, 0.7, 1.25 }; // mm
  const double origin[3] = { -22.4, -22.4, 100.0 };
  image->SetRegions(ImageType::SizeType{ { 64, 64, 20 } });
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->Allocate();
  for (itk::ImageRegionIteratorWithIndex<ImageType> voxel(image, image->GetBufferedRegion()); !voxel.IsAtEnd(); ++voxel)
  {
    const auto & index = voxel.GetIndex();
    voxel.Set(static_cast<short>(index[0] * index[1] - 50 * index[2]));
  }

  for (const std::string extension : { ".nrrd", ".nii.gz", ".mha" })
  {
    const std::string path = argv[1] + ("/volume" + extension);
    shapeton::WriteVolume(image.GetPointer(), path, { { "source", "ExampleVolumeFiles" } });
    const shapeton::Volume volume = shapeton::ReadImageFile(path); // float voxels

    int                                                        differences = 0;
    itk::ImageRegionConstIterator<shapeton::Volume::ImageType> copy(volume.image, volume.image->GetBufferedRegion());
    itk::ImageRegionConstIterator<ImageType>                   voxel(image, image->GetBufferedRegion());
    for (; !voxel.IsAtEnd(); ++voxel, ++copy)
    {
      differences += voxel.Get() != copy.Get();
    }
    std::cout << extension << ": " << (shapeton::HaveSameGrid(image, volume.image) ? "same" : "another") << " grid, "
              << differences << " voxels differ\n";
  }
}
