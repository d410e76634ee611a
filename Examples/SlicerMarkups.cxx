// Writes a curve and a point as markups of 3D Slicer, and a color table; reads the markups back.
// Usage: ExampleSlicerMarkups MARKUPS.mrk.json COLORS.ctbl
#include "shapetonColorTable.h"
#include "shapetonSlicerMarkups.h"

#include <cmath>
#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " MARKUPS.mrk.json COLORS.ctbl\n";
    return 2;
  }
  shapeton::CurveSet helix; // LPS, mm
  helix.V.resize(501, 3);
  helix.curves.emplace_back();
  for (int i = 0; i <= 500; ++i)
  {
    helix.V.row(i) << 30.0 * std::cos(0.05 * i), 30.0 * std::sin(0.05 * i), 0.2 * i;
    helix.curves[0].push_back(i);
  }
  shapeton::Markup curve = shapeton::MarkupOfCurve(helix, 0, shapeton::Markup::Kind::Curve, 5.0);
  curve.name = "Helix";
  shapeton::Markup point;
  point.name = "Begin";
  point.points = { helix.V.row(0).transpose() };
  shapeton::WriteMarkups({ curve, point }, argv[1]);
  shapeton::WriteColorTable({ { 1, "gas", shapeton::ColorOfLabel(1) }, { 2, "fluid", shapeton::ColorOfLabel(2) } },
                            argv[2]);

  const auto   markups = shapeton::ReadMarkups(argv[1]);
  const auto & points = markups.front().points;
  std::cout << markups.size() << " markups; " << markups.front().name << ": " << points.size()
            << " control points instead of " << helix.V.rows() << ", ends "
            << (points.back() - helix.V.row(500).transpose()).norm() << " mm from the end of the curve\n";
}
