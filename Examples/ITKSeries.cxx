// From a DICOM series, read with ITK, to heat, shapetons and objects with automatic parameters: the bytes of the tools.
// Usage: ExampleITKSeries DICOM_FOLDER HEAT.nrrd OBJECTS.nrrd VISITS.nrrd
#include "ITKSeries.h"

#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonHeatObjectsImageFilter.h"
#include "shapetonHeatParameterChoice.h"
#include "shapetonParticleDiffusionImageFilter.h"
#include "shapetonParticlePreset.h"
#include "shapetonVolumeWriter.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 5)
  {
    std::cerr << "Usage: " << argv[0] << " DICOM_FOLDER HEAT.nrrd OBJECTS.nrrd VISITS.nrrd\n";
    return 2;
  }
  try
  {
    using ImageType = itk::Image<float, 3>;
    const ImageType::Pointer   ct = ReadITKSeries(argv[1]);
    const shapeton::VolumeView view(ct.GetPointer()); // with the modality

    const auto heat = shapeton::CumulativeHeatDiffusionImageFilter<ImageType>::New();
    heat->SetInput(ct);
    heat->UseParameters(shapeton::ChooseHeatParameters(view, heat->GetOptions()));
    const auto objects = shapeton::HeatObjectsImageFilter::New();
    objects->SetInput(heat->GetOutput());
    objects->Update();
    shapeton::WriteVolume(heat->GetOutput(), argv[2]);
    shapeton::WriteVolume(objects->GetOutput(), argv[3]);

    const auto shapetons = shapeton::ParticleDiffusionImageFilter<ImageType>::New();
    shapetons->SetInput(ct);
    shapetons->SetOptions(shapeton::ChooseShapetonParameters(view, {}).options);
    shapetons->Update();
    shapeton::WriteVolume(shapetons->GetOutput(), argv[4]);
    std::cout << view.modality << ", " << objects->GetObjects().size() << " objects, " << shapetons->GetShapetons()
              << " shapetons\n";
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
