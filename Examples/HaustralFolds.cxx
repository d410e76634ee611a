// Finds haustral folds on the flat map of a tube with four folds at known positions.
// Usage: ExampleHaustralFolds FOLDS.csv
#include "shapetonColonFlattening.h"
#include "shapetonHaustralFoldFiles.h"
#include "shapetonPi.h"

#include <algorithm>
#include <cmath>
#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " FOLDS.csv\n";
    return 2;
  }
  const double          places[4][2] = { { 30.0, 2.0 }, { 55.0, 0.0 }, { 90.0, 4.0 }, { 125.0, 3.0 } }; // mm, radians
  constexpr int         around = 120, along = 160;
  shapeton::SurfaceMesh tube; // radius 20 mm, length 160 mm
  tube.V.resize(around * (along + 1), 3);
  tube.F.resize(2 * around * along, 3);
  for (int i = 0; i < tube.V.rows(); ++i)
  {
    const double angle = shapeton::TwoPi * (i % around) / around;
    const double z = i / around;
    double       radius = 20.0;
    for (const auto & place : places) // 6 mm high, 1.5 mm thick, 36 mm long
    {
      const double side = std::min(1.0, std::abs(std::remainder(angle - place[1], shapeton::TwoPi)) * 20.0 / 18.0);
      radius -= 6.0 * (1.0 - side * side * side) * std::exp(-0.5 * std::pow((z - place[0]) / 1.5, 2));
    }
    tube.V.row(i) << radius * std::cos(angle), radius * std::sin(angle), z;
    const int next = i % around + 1 < around ? i + 1 : i + 1 - around;
    if (i < around * along)
    {
      tube.F.row(2 * i) << i, next, next + around; // counterclockwise from outside
      tube.F.row(2 * i + 1) << i, next + around, i + around;
    }
  }

  shapeton::ColonFlatteningSettings options;
  options.metric = shapeton::FlatMetric::Euclidean;
  const shapeton::ColonFlattening flattening = shapeton::FlattenColon(tube, "the tube", options);
  const shapeton::FlatColon       flat(flattening.map.flat); // pixels of 1 mm
  const shapeton::HaustralFolds   folds = shapeton::FindHaustralFolds(flat);
  shapeton::TableOfFolds(folds).Write(argv[1]);
  std::cout << folds.folds.size() << " folds\n";
  for (const shapeton::HaustralFold & fold : folds.folds)
  {
    std::cout << "fold at " << std::lround(fold.center.z()) << " mm: " << fold.length << " mm long, " << fold.height
              << " mm high, reliability " << fold.reliability << '\n';
  }
}
