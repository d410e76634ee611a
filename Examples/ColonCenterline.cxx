// The centerline of a synthetic colon from a mask of its lumen, and the distension of the colon.
// Usage: ExampleColonCenterline CENTERLINE.vtp
#include "shapetonColonCenterline.h"
#include "shapetonColonDistension.h"
#include "shapetonColonPhantomImageSource.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " CENTERLINE.vtp\n";
    return 2;
  }
  const auto phantom = shapeton::ColonPhantomImageSource::New();
  phantom->SetSize({ { 128, 128, 120 } });
  phantom->SetSpacing(shapeton::ColonPhantomImageSource::SpacingType(2.8)); // mm
  phantom->CenterOutput();
  phantom->TruthOnlyOn(); // the mask without the CT
  phantom->Update();

  const shapeton::ColonCenterline centerline = shapeton::TraceColonCenterline(phantom->GetLumenOutput());
  shapeton::WriteCurves(centerline.curve, argv[1]);
  const shapeton::ColonDistension distension = shapeton::MeasureDistension(centerline.curve);
  std::cout << "mean caliber " << distension.meanCaliber << " mm, " << 100.0 * distension.share
            << " % of the length at least 10 mm wide\n";
  const shapeton::CurveSet truth = phantom->GetAnatomy().Centerline();
  double                   sum = 0.0;
  for (Eigen::Index i = 0; i < centerline.curve.V.rows(); ++i)
  {
    sum += (truth.V.rowwise() - centerline.curve.V.row(i)).rowwise().norm().minCoeff();
  }
  std::cout << centerline.length / 10.0 << " cm, truth " << phantom->GetAnatomy().Length() / 10.0 << " cm; "
            << sum / static_cast<double>(centerline.curve.V.rows()) << " mm from the true line on average, "
            << centerline.gaps.size() << " gaps\n";
}
