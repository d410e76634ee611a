// Writes the bright voxels of a series as a DICOM Segmentation that refers to it, and reads it back.
// Usage: ExampleDicomResults FOLDER OUTPUT.dcm
#include "shapetonDicomSegmentation.h"
#include "shapetonDicomSegmentationReader.h"
#include "shapetonDicomText.h"
#include "shapetonMappedImage.h"
#include "shapetonVolumeReader.h"

#include <algorithm>
#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " FOLDER OUTPUT.dcm\n";
    return 2;
  }
  const shapeton::Volume      volume = shapeton::ReadVolume(argv[1]);
  const shapeton::DicomSource source = shapeton::ReadDicomSource(argv[1]);
  const auto                  labels = shapeton::MapVoxels<unsigned short>(volume.image.GetPointer(),
                                                          [](float hounsfield) { return hounsfield > 0.0F ? 1 : 0; });

  shapeton::DicomSegment bright;
  bright.name = "bright";
  bright.category = { "123037004", "SCT", "Anatomical Structure" };
  bright.type = { "BRIGHT", "99EXAMPLE", "Above 0 HU" };
  bright.trackingID = bright.name;
  bright.trackingUID = shapeton::MakeDicomUID("bright in " + source.series.uid);
  bright.labels = labels;
  const auto written =
    shapeton::WriteDicomSegmentation(source, { bright }, { "Example", "1.0", 300, "Research: bright" }, argv[2]);

  const auto back = shapeton::ReadDicomSegments(shapeton::ReadDicomSegmentation(argv[2]), { 1 }, source);
  const bool isSame = std::equal(labels->GetBufferPointer(),
                                 labels->GetBufferPointer() + labels->GetBufferedRegion().GetNumberOfPixels(),
                                 back.labels->GetBufferPointer());
  std::cout << written.voxels[0] << " voxels written, " << back.voxels[0] << " read, "
            << (isSame ? "all the same" : "different") << "\n";
}
