#include "shapetonVolumeFileServices.h"

// The program that a shapeton::ContainedProcess starts to parse untrusted files.

namespace
{
const shapeton::AddContainedServices volumeFiles(shapeton::VolumeFileServices());
}

int
main(int argc, char * argv[])
{
  return shapeton::ServeContained(argc, argv);
}
