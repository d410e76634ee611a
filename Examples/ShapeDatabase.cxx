// Stores named shape signatures in an SQLite file and reads them back.
// Usage: ExampleShapeDatabase VOLUME LABELS DATABASE
#include "shapetonShapeDatabase.h"
#include "shapetonVolumeReader.h"

#include <filesystem>
#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 4)
  {
    std::cerr << "Usage: " << argv[0] << " VOLUME LABELS DATABASE\n";
    return 2;
  }
  const shapeton::Volume volume = shapeton::ReadVolume(argv[1]);
  const shapeton::Volume labels = shapeton::ReadVolume(argv[2]);
  const auto             table = shapeton::DescribeShapes(volume.image, labels.image);
  std::filesystem::remove(argv[3]); // a second run could not add the same table again
  shapeton::AddToShapeDatabase(argv[3], table, labels.identity, "example");
  for (const shapeton::NamedShape & shape : shapeton::ReadShapeDatabase(argv[3]))
  {
    std::cout << shape.name << ": " << shape.signature.volume << " mm^3\n";
  }
}
