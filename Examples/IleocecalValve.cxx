// Finds the ileocecal valve of a synthetic colon from a mask of its lumen.
// Usage: ExampleIleocecalValve
#include "shapetonColonCenterline.h"
#include "shapetonColonPhantomImageSource.h"
#include "shapetonIleocecalValve.h"

#include <iostream>

int
main()
{
  const auto phantom = shapeton::ColonPhantomImageSource::New();
  phantom->SetParameters(shapeton::ColonPhantomPreset("realistic"));
  phantom->SetSize({ { 170, 170, 160 } });
  phantom->SetSpacing(shapeton::ColonPhantomImageSource::SpacingType(2.0)); // mm
  phantom->CenterOutput();
  phantom->TruthOnlyOn(); // the mask without the CT
  phantom->Update();

  const shapeton::ColonCenterline line = shapeton::TraceColonCenterline(phantom->GetLumenOutput());
  const shapeton::ValveSearch     search =
    shapeton::FindIleocecalValve(phantom->GetLumenOutput(), nullptr, line.curve); // by shape only
  if (!search.valve)
  {
    std::cout << "not found: " << search.reason << '\n';
    return 0;
  }
  std::cout << "confidence " << search.valve->confidence << ", "
            << (search.valve->position - phantom->GetAnatomy().Valve().position).norm()
            << " mm from the true position, " << line.length - search.valve->arcLength
            << " mm before the end of the centerline\n";
}
