#include "shapetonVolumeFileServices.h"
#if defined(SHAPETON_HAS_DICOM_RESULTS)
#  include "shapetonDicomResultServices.h"
#endif

// The program that a shapeton::ContainedProcess starts to parse untrusted files.
int
main(int argc, char * argv[])
{
  shapeton::ContainedServices services = shapeton::VolumeFileServices();
#if defined(SHAPETON_HAS_DICOM_RESULTS)
  services.merge(shapeton::DicomResultServices());
#endif
  return shapeton::ServeContained(argc, argv, services);
}
