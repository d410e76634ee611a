// From a DICOM series of CT colonography, read with ITK, to the lumen and a flat picture of the colon: the bytes of the
// tools. Usage: ExampleColonPipeline DICOM_FOLDER LUMEN.nrrd FLAT.png
#include "ITKSeries.h"

#include "shapetonColonFlatteningFilter.h"
#include "shapetonColonModelFilter.h"
#include "shapetonFlatColonPictures.h"
#include "shapetonVolumeWriter.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 4)
  {
    std::cerr << "Usage: " << argv[0] << " DICOM_FOLDER LUMEN.nrrd FLAT.png\n";
    return 2;
  }
  try
  {
    const auto model = shapeton::ColonModelFilter<itk::Image<float, 3>>::New();
    model->SetInput(ReadITKSeries(argv[1])); // with the patient position
    model->SetFaces(20000);
    const auto flattening = shapeton::ColonFlatteningFilter<>::New();
    flattening->SetInput(model->GetOutput());
    flattening->SetCenterline(model->GetCenterlineOutput());
    flattening->Update();
    shapeton::WriteVolume(model->GetModelOutput()->Get().lumen.labels.GetPointer(), argv[2]);

    const shapeton::FlatColon & flat = flattening->GetFlatColonOutput()->Get();
    shapeton::FlatColonParts    parts;
    parts.flat = &flat;
    parts.centerline = &model->GetCenterlineOutput()->Get();
    const auto picture = shapeton::FlatColonPictures(parts, 1.0).Draw(shapeton::FlatColoring::Curvature, "Flat colon");
    shapeton::WritePng(picture, argv[3]);
    std::cout << shapeton::SurfaceOf(*flattening->GetOutput()).NumberOfFaces() << " faces are flat\n";
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
