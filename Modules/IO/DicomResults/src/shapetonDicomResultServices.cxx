#include "shapetonDicomResultServices.h"

#include "shapetonDicomReading.h"

namespace shapeton
{
ContainedServices
DicomResultServices()
{
  return { { DicomReportService, MakeDicomReportService },
           { DicomSegmentationService, MakeDicomSegmentationService },
           { DicomSegmentPixelService, MakeDicomSegmentPixelService },
           { DicomSourceService, MakeDicomSourceService } };
}
} // namespace shapeton
