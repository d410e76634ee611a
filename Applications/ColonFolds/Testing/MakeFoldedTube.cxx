// Writes flat tubes for the tests: MakeFoldedTube FOLDER
#include "itkFoldTubes.h"

#include "itkCurveSet.h"
#include "itkSurfaceWriter.h"

#include <string>

namespace
{
itk::CurveSet
Line(double distanceFromAxis)
{
  itk::CurveSet curves;
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
  // The second lies across the cut, the third consists of two that meet on the line.
  const itk::SurfaceMesh folded = foldtubes::MakeTube({ { 25.0, 2.0, 18.0, 6.0 },
                                                        { 50.0, 0.0, 15.0, 5.0 },
                                                        { 80.0, 4.0, 30.0, 8.0, 0.22 },
                                                        { 105.0, 1.5, 22.0, 7.0, 0.0, 0.25 },
                                                        { 135.0, 3.0, 12.0, 4.0 } });
  itk::WriteSurface(folded, folder + "/folded.vtp");
  itk::WriteSurface(foldtubes::MakeTube({}), folder + "/smooth.vtp");
  itk::SurfaceMesh notFlat = foldtubes::MakeTube({});
  notFlat.pointArrays.clear();
  itk::WriteSurface(notFlat, folder + "/notFlat.vtp");
  itk::WriteCurves(Line(foldtubes::radius), folder + "/taenia.vtp");
  itk::WriteCurves(Line(500.0), folder + "/elsewhere.vtp");
  return 0;
}
