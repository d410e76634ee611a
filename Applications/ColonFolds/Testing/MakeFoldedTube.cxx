// Writes flat tubes for the tests: MakeFoldedTube FOLDER
#include "shapetonFoldTubes.h"

#include "shapetonCurveSet.h"
#include "shapetonSurfaceWriter.h"

#include <string>

namespace
{
shapeton::CurveSet
Line(double distanceFromAxis)
{
  shapeton::CurveSet curves;
  curves.V.resize(81, 3);
  curves.curves.emplace_back();
  for (int i = 0; i <= 80; ++i)
  {
    curves.V.row(i) = flattubes::OnCylinder(distanceFromAxis, 2.0 * i, -4.0);
    curves.curves[0].push_back(i);
  }
  return curves;
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    return 2;
  }
  const std::string folder = argv[1];
  // The second fold crosses the cut; the third consists of two folds that meet on the taenia.
  const shapeton::SurfaceMesh folded = foldtubes::MakeTube({ { 25.0, 2.0, 18.0, 6.0 },
                                                             { 50.0, 0.0, 15.0, 5.0 },
                                                             { 80.0, 4.0, 30.0, 8.0, 0.22 },
                                                             { 105.0, 1.5, 22.0, 7.0, 0.0, 0.25 },
                                                             { 135.0, 3.0, 12.0, 4.0 } });
  shapeton::WriteSurface(folded, folder + "/folded.vtp");
  shapeton::WriteSurface(foldtubes::MakeTube({}), folder + "/smooth.vtp");
  shapeton::SurfaceMesh notFlat = foldtubes::MakeTube({});
  notFlat.pointArrays.clear();
  shapeton::WriteSurface(notFlat, folder + "/notFlat.vtp");
  shapeton::WriteCurves(Line(foldtubes::radius), folder + "/taenia.vtp");
  shapeton::WriteCurves(Line(500.0), folder + "/elsewhere.vtp");
  return 0;
}
