#include "Tables.h"
#include "ValidationReport.h"
#include "ValidationVolumes.h"

#include "shapetonAutomaticParameters.h"
#include "shapetonDiffusionTestVolumes.h"

using namespace shapeton;

namespace
{
/** Largest error of all recorded fields relative to the same steps in double precision. */
double
LargestError(const test::Volume &               volume,
             double                             p,
             HeatDiffusionSolver::Method        method,
             const std::vector<std::uint64_t> & steps)
{
  const VolumeGradientOperator volumeGradient(volume, test::OptionsWith(p));
  const auto                   fields = HeatAt(volumeGradient, steps, method);
  test::BruteForce             brute(volume, p, HeatDiffusionSolver::MaximumTimeStepLength);
  double                       largest = 0.0;
  std::uint64_t                step = 0;
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    for (; step < steps[i]; ++step)
    {
      brute.Step();
    }
    largest = std::max(largest, test::LargestDifference(fields[i], brute.heat));
  }
  return largest;
}
} // namespace

void
ValidateAccuracyOfHeat(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText("Volumes of balls and boxes in noise. Error: largest difference between a recorded step and explicit "
                 "steps in double precision.");
  CsvTable table({ "side, voxels", "spacing, mm", "p", "solver", "rows", "last step", "largest error", "bound", "" });
  const std::uint64_t last = settings.quick ? 1000 : 10000;
  double              largest = 0.0;
  const auto          add = [&](std::size_t                   side,
                       double                        p,
                       const std::array<double, 3> & spacing,
                       HeatDiffusionSolver::Method   method,
                       std::size_t                   rows) {
    const test::Volume volume = test::MakeScene({ side, side, side }, 0.05, spacing);
    const auto         steps = MakeSnapshotSteps(last, rows, SnapshotSpacing::Logarithmic);
    const double       error = LargestError(volume, p, method, steps);
    largest = std::max(largest, error);
    table.AddRow(Cells() << side
                         << CsvTable::Number(spacing[0]) + ", " + CsvTable::Number(spacing[1]) + ", " +
                              CsvTable::Number(spacing[2])
                         << p << (method == HeatDiffusionSolver::Method::Chebyshev ? "chebyshev" : "explicit")
                         << steps.size() << last << Rounded(error, 2) << "1e-5" << report.Check(error <= 1e-5));
  };
  using Method = HeatDiffusionSolver::Method;
  const std::array<double, 3> cubic = { { 1.0, 1.0, 1.0 } };
  const std::array<double, 3> anisotropic = { { 0.7, 0.9, 2.5 } };
  const std::size_t           side = settings.quick ? 16 : 32;
  for (const double p : { 2.0, 5.0, 7.0, 15.0 })
  {
    add(side, p, cubic, Method::Chebyshev, 512);
    add(side, p, anisotropic, Method::Chebyshev, 512);
  }
  add(side, 7.0, cubic, Method::Chebyshev, 2); // only the last step, in a single expansion
  add(side, 7.0, cubic, Method::Explicit, 20);
  if (!settings.quick)
  {
    add(64, 7.0, cubic, Method::Chebyshev, 512);
    add(64, 10.0, anisotropic, Method::Chebyshev, 2);
  }
  report.AddRows("volumes", table);
  report.AddText("Largest error of all volumes: " + Rounded(largest, 2) +
                 ". Bound for each: 1e-5, the default tolerance.");
}
