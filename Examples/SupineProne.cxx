// Registers the walls of a synthetic colon in two positions and measures the error at points known in both positions.
// Usage: ExampleSupineProne
#include "shapetonColonFlattening.h"
#include "shapetonColonFlexures.h"
#include "shapetonColonModel.h"
#include "shapetonColonPhantomImageSource.h"
#include "shapetonColonPointPairs.h"
#include "shapetonRegistrationErrors.h"

#include <cmath>
#include <iostream>
#include <string>

using Phantom = shapeton::ColonPhantomImageSource;

static Phantom::Pointer
MakePatient(const std::string & position)
{
  const auto                       phantom = Phantom::New();
  shapeton::ColonPhantomParameters parameters; // same patient: same seed
  parameters.position = position;
  phantom->SetParameters(parameters);
  phantom->SetSize({ { 128, 128, 120 } });
  phantom->SetSpacing(Phantom::SpacingType(2.8)); // mm
  phantom->CenterOutput();
  phantom->TruthOnlyOn(); // the lumen mask, without the CT
  phantom->Update();
  return phantom;
}

static shapeton::ColonPosition
Examine(Phantom * phantom)
{
  shapeton::ColonModelSettings modelOptions;
  modelOptions.faces = 20000;
  const shapeton::ColonModel        colon = shapeton::BuildColonModelOfLumen(phantom->GetLumenOutput(), modelOptions);
  shapeton::ColonFlatteningSettings options;
  options.metric = shapeton::FlatMetric::Euclidean;
  const auto flattening = shapeton::FlattenColon(colon.wall.simplified, "the wall", options);
  const auto flexures = shapeton::FindColonFlexures(colon.centerline.curve).flexures;

  shapeton::ColonPosition position;
  position.name = phantom->GetParameters().position;
  position.flat = std::make_shared<shapeton::FlatColon>(flattening.map.flat);
  position.centerline = colon.centerline.curve;
  // position.taeniae is empty: the rotation is determined by the folds only
  position.folds = shapeton::FindHaustralFolds(*position.flat).folds;
  for (int i = 0; i < 4; ++i)
  {
    position.flexures[i] = flexures[i].isFound ? flexures[i].arcLength : std::nan("");
    position.flexureConfidence[i] = flexures[i].confidence;
  }
  position.isExcluded = shapeton::FindExcludedColumns(*position.flat, position.centerline);
  return position;
}

int
main()
{
  const auto                              supine = MakePatient("supine");
  const auto                              prone = MakePatient("prone");
  const shapeton::SupineProneRegistration registration =
    shapeton::RegisterColonPositions(Examine(supine), Examine(prone));

  const shapeton::CsvTable table =
    shapeton::TableOfPointPairs(supine->GetAnatomy().Correspondence(), prone->GetAnatomy().Correspondence());
  std::vector<shapeton::PointPair> pairs;
  for (const auto & row : table.GetRows())
  {
    pairs.push_back({ { std::stod(row[0]), std::stod(row[1]), std::stod(row[2]) },
                      { std::stod(row[3]), std::stod(row[4]), std::stod(row[5]) } });
  }
  const shapeton::RegistrationErrors errors = shapeton::MeasureRegistrationErrors(registration, pairs);
  std::cout << registration.matches.size() << " folds matched, " << registration.figures.flips << " flips, confidence "
            << registration.confidence.whole << ", mean error " << errors.Mean() << " mm at " << errors.inSpace.size()
            << " points\n";
}
