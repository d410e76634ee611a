// Flexures, segments and taeniae on the wall of a synthetic colon, and their distance from the ground truth.
// Usage: ExampleColonLandmarks TAENIAE.vtp
#include "shapetonColonFlattening.h"
#include "shapetonColonLandmarks.h"
#include "shapetonColonModel.h"
#include "shapetonColonPhantomImageSource.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " TAENIAE.vtp\n";
    return 2;
  }
  const auto phantom = shapeton::ColonPhantomImageSource::New();
  phantom->SetSize({ { 180, 180, 168 } });
  phantom->SetSpacing(shapeton::ColonPhantomImageSource::SpacingType(2.0)); // mm
  phantom->CenterOutput();
  phantom->TruthOnlyOn(); // the lumen mask, without the CT
  phantom->Update();
  shapeton::ColonModelSettings modelOptions;
  modelOptions.faces = 30000;
  const shapeton::ColonModel        colon = shapeton::BuildColonModelOfLumen(phantom->GetLumenOutput(), modelOptions);
  shapeton::ColonFlatteningSettings options;
  options.metric = shapeton::FlatMetric::Euclidean;
  const auto flattening = shapeton::FlattenColon(colon.wall.simplified, "the wall", options);
  const auto landmarks = shapeton::FindColonLandmarks(shapeton::FlatColon(flattening.map.flat), colon.centerline.curve);

  const shapeton::ColonAnatomy & anatomy = phantom->GetAnatomy();
  for (const shapeton::ColonFlexure & flexure : landmarks.flexures.flexures)
  {
    std::cout << shapeton::NameOfFlexure(flexure.number) << " flexure at " << flexure.arcLength << " mm, between "
              << anatomy.SegmentName(anatomy.SegmentAt(flexure.arcLength - 60.0)) << " and "
              << anatomy.SegmentName(anatomy.SegmentAt(flexure.arcLength + 60.0)) << '\n';
  }
  const shapeton::CurveSet taeniae = shapeton::TaeniaCurves(landmarks.taeniae);
  shapeton::WriteCurves(taeniae, argv[1]);
  const shapeton::CurveSet truth = anatomy.Taeniae();
  double                   sum = 0.0;
  for (Eigen::Index i = 0; i < taeniae.V.rows(); ++i)
  {
    sum += (truth.V.rowwise() - taeniae.V.row(i)).rowwise().norm().minCoeff();
  }
  std::cout << landmarks.flexures.NumberFound() << " flexures, " << landmarks.segments.borders.size()
            << " borders of segments, " << taeniae.curves.size() << " taeniae, "
            << sum / static_cast<double>(taeniae.V.rows()) << " mm from the true ones on average\n";
}
