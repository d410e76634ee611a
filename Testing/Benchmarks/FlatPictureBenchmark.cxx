// Wall and CPU time of each step of flat pictures of a generated colon of 55,000 faces, at 3000 x 200 and 12000 x 800
// pixels.
#include "Times.h"

#include "shapetonFlatColonPage.h"
#include "shapetonFlatColonStrip.h"
#include "shapetonFlatCoordinateMap.h"
#include "shapetonFlatTestTubes.h"
#include "shapetonQuantiles.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
using namespace flattubes;
using Ct = itk::Image<float, 3>;

constexpr double circumference = 100.0;
constexpr double length = 1500.0;
constexpr int    repetitions = 3;

/** Semilunar folds between three taeniae. */
double
RadiusAt(double u, double angle)
{
  const double turn = angle / (2.0 * pi);
  const double third = 3.0 * (turn - std::floor(turn));
  const double phase = u / 34.0 + 0.3 * std::floor(third);
  const double ridge = std::exp(-std::pow((phase - std::floor(phase) - 0.5) / 0.09, 2));
  return circumference / (2.0 * pi) - 6.0 * ridge * std::pow(std::sin(pi * third), 2);
}

shapeton::SurfaceMesh
MakeWall()
{
  TubeForm form;
  form.around = 60;
  form.along = 458;
  form.circumference = circumference;
  form.length = length;
  return MakeFlatTube(form, [](double u, double angle) { return OnCylinder(RadiusAt(u, -angle), u, -angle); });
}

Ct::Pointer
MakeCt()
{
  constexpr double half = 24.0;
  constexpr double spacing = 0.75;
  const auto       ct = Ct::New();
  ct->SetRegions(Ct::SizeType{ { 65, 65, 2030 } });
  const double spacings[] = { spacing, spacing, spacing };
  const double origin[] = { -half, -half, -10.0 };
  ct->SetSpacing(spacings);
  ct->SetOrigin(origin);
  ct->Allocate();
  float * voxel = ct->GetBufferPointer();
  for (int z = 0; z < 2030; ++z)
  {
    for (int y = 0; y < 65; ++y)
    {
      for (int x = 0; x < 65; ++x)
      {
        const double px = spacing * x - half, py = spacing * y - half;
        const double outside = std::hypot(px, py) - RadiusAt(spacing * z - 10.0, std::atan2(py, px));
        *voxel++ = static_cast<float>(-1000.0 + 1040.0 * std::clamp(outside / 1.2 + 0.5, 0.0, 1.0));
      }
    }
  }
  return ct;
}

/** Median time of some repetitions, and their CPU time. */
void
Time(const char * what, const std::function<void()> & run)
{
  Times times;
  for (int i = 0; i < repetitions; ++i)
  {
    times.Measure(run);
  }
  std::printf("  %-28s %8.3f s   processor %8.3f s\n",
              what,
              shapeton::UpperMedian(times.elapsed),
              shapeton::UpperMedian(times.processor));
}

void
TimePictures(const shapeton::SurfaceMesh & wall, const Ct * ct, double pixelSize)
{
  shapeton::FlatColonGridOptions options;
  options.pixelSize = pixelSize;
  const shapeton::FlatColonGrid grid(wall, options);
  const shapeton::FlatColonAxis axis = MakeFlatColonAxis(grid);
  const auto                    distances = DistanceOfColumns(grid);
  const auto                    strip = PaintFlatVolume(grid, axis, ct);
  std::printf("%d x %d pixels, %d faces\n", grid.Columns(), grid.Rows(), static_cast<int>(wall.F.rows()));
  Time("grid", [&] { shapeton::FlatColonGrid(wall, options); });
  Time("axis of the tube", [&] { MakeFlatColonAxis(grid); });
  Time("coordinate map", [&] { MakeFlatCoordinateMap(grid); });
  Time("shaded relief", [&] { PaintFlatRelief(grid, axis); });
  Time("curvature", [&] { PaintFlatCurvature(grid, axis); });
  Time("volume rendering", [&] { PaintFlatVolume(grid, axis, ct); });
  if (const auto use = ChooseFlatVolumeDevice(ct, shapeton::Device::Automatic); use.gpu)
  {
    Time("volume rendering on the GPU", [&] { PaintFlatVolume(grid, axis, ct, {}, use); });
  }
  Time("page of rows", [&] { DrawFlatColonPage(strip, grid, distances); });
}

} // namespace

int
main()
{
  const shapeton::SurfaceMesh wall = MakeWall();
  const auto                  ct = MakeCt();
  for (const double pixelSize : { 0.5, 0.125 })
  {
    TimePictures(wall, ct, pixelSize);
  }
}
