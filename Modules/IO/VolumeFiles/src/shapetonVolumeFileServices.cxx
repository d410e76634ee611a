#include "shapetonVolumeFileServices.h"

#include "shapetonParsingServices.h"

namespace shapeton
{
ContainedServices
VolumeFileServices()
{
  return { { DicomHeaderService, MakeDicomHeaderService },
           { DicomPixelService, MakeDicomPixelService },
           { ImageFileService, MakeImageFileService } };
}
} // namespace shapeton
