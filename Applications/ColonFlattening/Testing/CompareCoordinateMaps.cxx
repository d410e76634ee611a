// CompareCoordinateMaps MAP BASELINE TOLERANCE: status 0 if two coordinate maps have the same grid and no point is
// farther than TOLERANCE mm from its counterpart. itkTestDriver compares only the first vector component.
#include "shapetonFlatCoordinateMap.h"

#include "itkImageFileReader.h"
#include "itkNrrdImageIO.h"

#include <cstdlib>
#include <iostream>

namespace
{
shapeton::FlatCoordinateMap::Pointer
Read(const char * path)
{
  const auto reader = itk::ImageFileReader<shapeton::FlatCoordinateMap>::New();
  reader->SetFileName(path);
  reader->SetImageIO(itk::NrrdImageIO::New());
  reader->Update();
  return reader->GetOutput();
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc != 4)
  {
    std::cerr << "usage: CompareCoordinateMaps MAP BASELINE TOLERANCE\n";
    return EXIT_FAILURE;
  }
  const auto map = Read(argv[1]);
  const auto baseline = Read(argv[2]);
  if (map->GetBufferedRegion() != baseline->GetBufferedRegion() ||
      (map->GetSpacing() - baseline->GetSpacing()).GetNorm() > 1e-4 ||
      (map->GetOrigin() - baseline->GetOrigin()).GetNorm() > 1e-2 || map->GetDirection() != baseline->GetDirection())
  {
    std::cerr << argv[1] << ": the grid differs from " << argv[2] << '\n';
    return EXIT_FAILURE;
  }
  double farthest = 0.0;
  for (itk::SizeValueType i = 0; i < map->GetBufferedRegion().GetNumberOfPixels(); ++i)
  {
    const double distance = (map->GetBufferPointer()[i] - baseline->GetBufferPointer()[i]).GetNorm();
    farthest = std::isnan(distance) || distance > farthest ? distance : farthest;
  }
  std::cout << "farthest point: " << farthest << " mm\n";
  return farthest <= std::atof(argv[3]) ? EXIT_SUCCESS : EXIT_FAILURE;
}
