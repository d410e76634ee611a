// The centreline of a synthetic colon from a mask of its lumen, and how well the colon is distended.
// Usage: ExampleColonCentreline CENTRELINE.vtp
#include "shapetonColonCentreline.h"
#include "shapetonColonDistension.h"
#include "shapetonColonPhantomImageSource.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " CENTRELINE.vtp\n";
    return 2;
  }
  const auto phantom = shapeton::ColonPhantomImageSource::New();
  phantom->SetSize({ { 128, 128, 120 } });
  phantom->SetSpacing(shapeton::ColonPhantomImageSource::SpacingType(2.8)); // mm
  phantom->CenterOutput();
  phantom->TruthOnlyOn(); // the mask without the CT
  phantom->Update();

  const shapeton::ColonCentreline centreline = shapeton::TraceColonCentreline(phantom->GetLumenOutput());
  shapeton::WriteCurves(centreline.curve, argv[1]);
  for (const shapeton::SegmentDistension & segment : shapeton::MeasureDistension(centreline.curve))
  {
    std::cout << segment.name << ": mean calibre " << segment.meanCalibre << " mm\n";
  }
  const shapeton::CurveSet truth = phantom->GetAnatomy().Centreline();
  double                   sum = 0.0;
  for (Eigen::Index i = 0; i < centreline.curve.V.rows(); ++i)
  {
    sum += (truth.V.rowwise() - centreline.curve.V.row(i)).rowwise().norm().minCoeff();
  }
  std::cout << centreline.length / 10.0 << " cm, in truth " << phantom->GetAnatomy().Length() / 10.0 << " cm; "
            << sum / static_cast<double>(centreline.curve.V.rows()) << " mm from the true line on average, "
            << centreline.gaps.size() << " gaps\n";
}
