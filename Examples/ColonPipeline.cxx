// From a DICOM folder of CT colonography to a flat picture of the colon with an ITK pipeline.
// Usage: ExampleColonPipeline DICOM_FOLDER FLAT.png
#include "shapetonColonFlatteningFilter.h"
#include "shapetonColonModelFilter.h"
#include "shapetonFlatColonPictures.h"
#include "shapetonVolumeReader.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " DICOM_FOLDER FLAT.png\n";
    return 2;
  }
  try
  {
    const shapeton::Volume ct = shapeton::ReadVolume(argv[1]);

    const auto model = shapeton::ColonModelFilter<itk::Image<float, 3>>::New();
    model->SetInput(ct.image);
    model->SetPosition(ct.patientPosition);
    model->SetFaces(20000);
    const auto flattening = shapeton::ColonFlatteningFilter<>::New();
    flattening->SetInput(model->GetOutput());
    flattening->SetCenterline(model->GetCenterlineOutput());
    flattening->Update();

    const shapeton::FlatColon & flat = flattening->GetFlatColonOutput()->Get();
    shapeton::FlatColonParts    parts;
    parts.flat = &flat;
    parts.centerline = &model->GetCenterlineOutput()->Get();
    const auto picture = shapeton::FlatColonPictures(parts, 1.0).Draw(shapeton::FlatColoring::Curvature, "Flat colon");
    shapeton::WritePng(picture, argv[2]);
    std::cout << shapeton::SurfaceOf(*flattening->GetOutput()).NumberOfFaces() << " faces are flat\n";
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
