// Finds gas and tagged fluid in the CT of a synthetic patient, removes the fluid, and compares the results with the
// ground truth. Usage: ExampleColonLumen
#include "shapetonColonPhantomImageSource.h"
#include "shapetonElectronicCleansing.h"
#include "shapetonMappedImage.h"

#include "itkImage.h"

#include <iostream>

int
main()
{
  constexpr double spacing = 3.7; // mm
  using Phantom = shapeton::ColonPhantomImageSource;
  const auto phantom = Phantom::New();
  phantom->SetSize({ { 96, 96, 90 } });
  phantom->SetSpacing(Phantom::SpacingType(spacing));
  phantom->CenterOutput();
  phantom->Update();
  const auto ct = shapeton::MapVoxels<float>(phantom->GetOutput(), [](auto hounsfield) { return hounsfield; });

  shapeton::ColonLumenSettings options;
  options.position = "HFS"; // as in the DICOM header; supine, fluid at the back
  const shapeton::ColonLumen    lumen = shapeton::SegmentColonLumen(ct, options);
  const shapeton::CleansedColon cleansed = shapeton::CleanseColon(ct, lumen);

  double       both = 0.0, either = 0.0, occupied = 0.0;
  const auto * found = lumen.labels->GetBufferPointer();
  const auto * truth = phantom->GetLumenOutput()->GetBufferPointer();
  for (std::size_t i = 0; i < lumen.labels->GetPixelContainer()->Size(); ++i)
  {
    both += found[i] != 0 && truth[i] != 0;
    either += (found[i] != 0) + (truth[i] != 0);
  }
  for (std::size_t i = 0; i < cleansed.occupancy->GetPixelContainer()->Size(); ++i)
  {
    occupied += cleansed.occupancy->GetBufferPointer()[i] * spacing * spacing * spacing / 1000.0; // ml
  }
  std::cout << (lumen.isTagged ? "tagged" : "no tagged") << " fluid, " << lumen.levels.size() << " levels; Dice "
            << 2.0 * both / either << "; a lumen of " << occupied << " ml, truth " << phantom->GetFluid().LumenVolume()
            << " ml\n";
}
