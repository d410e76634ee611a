#include "Tables.h"
#include "ValidationReport.h"

#include "shapetonHeatDiffusionSolver.h"
#include "shapetonShapeComponents.h"
#include "shapetonDiffusionTestVolumes.h"
#include "shapetonPi.h"

#include <functional>

using namespace shapeton;

namespace
{
using Distance = std::function<double(double, double, double)>; // in voxels from the center; <= 0 inside

struct Measured
{
  ShapeComponent component;
  double         heatAfterManySteps{ 0.0 };
};

Measured
Measure(std::size_t side, const Distance & distance)
{
  test::Volume volume({ side, side, side });
  const double middle = (side - 1) / 2.0;
  volume.Fill(
    [&](double x, double y, double z) { return distance(x - middle, y - middle, z - middle) <= 0.0 ? 1.0 : 0.0; });
  const VolumeGradientOperator volumeGradient(volume);
  PaddedField                  heat(volumeGradient.GetGrid());
  volumeGradient.ComputeInitialHeat(heat);
  Measured measured;
  for (const auto & component : FindShapeComponents(volumeGradient, heat, { { 1.0, 1.0, 1.0 } }, 8))
  {
    if (component.closed)
    {
      measured.component = component;
      break;
    }
  }
  HeatDiffusionSolver solver(volumeGradient, HeatDiffusionSolver::Method::Chebyshev, 1.0 / 12.0, 1e-5);
  solver.Run(heat, 1000000);
  const auto & index = measured.component.index;
  measured.heatAfterManySteps = heat.GetData()[volumeGradient.GetGrid().GetRow(index[1], index[2]) + index[0]];
  return measured;
}

Distance
Sphere(double radius)
{
  return [radius](double x, double y, double z) { return std::hypot(x, y, z) - radius; };
}

Distance
TurnedCube(double side, double degrees)
{
  const double c = std::cos(degrees * shapeton::Pi / 180.0);
  const double s = std::sin(degrees * shapeton::Pi / 180.0);
  return [=](double x, double y, double z) {
    return std::max({ std::abs(c * x + s * y), std::abs(c * y - s * x), std::abs(z) }) - side / 2.0;
  };
}
} // namespace

void
ValidateHeatOfShapes(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText("Closed binary objects, p = 7. Their converged heat is (cut faces) / (6 voxels): 0.75 / radius for a "
                 "sphere and 1 / side for a cube. It is computed exactly from the components and by 1,000,000 steps. "
                 "The scale-normalized heat is area / (6 volume^(2/3)).");
  report.AddText("Bounds: closed form within 5 % for spheres and 1e-6 for the cube along the axes; difference after "
                 "1,000,000 steps 1e-5; scale-normalized heat within 3 % for spheres, 0.94 +- 0.06 for cubes of side "
                 "20. The exact value of a cube is 1; 13 directions underestimate flat faces.");
  CsvTable   table(Columns("object | voxels | closed form | heat, exact | within the bound | heat after 1e6 steps | "
                           "within 1e-5 | scale-normalized | within the bound of it"));
  const auto add = [&](const std::string & name,
                       const Measured &    m,
                       double              closedForm,
                       double              formBound,
                       double              normalized,
                       double              bound) {
    const bool hasForm = formBound > 0.0; // none for rotated cubes
    table.AddRow(
      Cells() << name << m.component.voxels << (hasForm ? Rounded(closedForm, 4) : "")
              << Rounded(m.component.convergedHeat, 5)
              << (hasForm ? report.Check(std::abs(m.component.convergedHeat / closedForm - 1.0) <= formBound) : "")
              << Rounded(m.heatAfterManySteps, 5)
              << report.Check(std::abs(m.component.convergedHeat - m.heatAfterManySteps) <= 1e-5)
              << Rounded(m.component.normalizedHeat, 4)
              << report.Check(std::abs(m.component.normalizedHeat - normalized) <= bound));
  };
  const double sphere = 4.0 * shapeton::Pi / (6.0 * std::pow(4.0 / 3.0 * shapeton::Pi, 2.0 / 3.0));
  for (const double radius : settings.quick ? std::vector<double>{ 8.0 } : std::vector<double>{ 4.0, 8.0, 16.0 })
  {
    add("sphere, radius " + CsvTable::Number(radius),
        Measure(44, Sphere(radius)),
        0.75 / radius,
        0.05,
        sphere,
        0.03 * sphere);
  }
  for (const double degrees :
       settings.quick ? std::vector<double>{ 0.0, 30.0 } : std::vector<double>{ 0.0, 10.0, 20.0, 30.0, 45.0 })
  {
    add("cube, side 20, rotated by " + CsvTable::Number(degrees),
        Measure(44, TurnedCube(20.0, degrees)),
        1.0 / 20.0,
        degrees == 0.0 ? 1e-6 : 0.0,
        0.94,
        0.06);
  }
  report.AddRows("shapes", table);
  report.AddText("According to section 2.3.4 of the dissertation, the heat is invariant to scale and orientation. "
                 "Neither is true. Doubling the radius of a sphere about halves its heat. A cube rotated by 30 degrees "
                 "has 27 % more heat than an axis-aligned one, because an oblique face cuts more grid edges.");
}
