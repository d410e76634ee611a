// Computes the heat diffusion distances of all edges of colon-like tubes, exactly and from 50, 200 and 500 eigenpairs,
// in one run. Arguments: numbers of faces. For the accuracy, see Utilities/run-validation flattening-metric.
#include "Times.h"

#include "shapetonColonTube.h"
#include "shapetonHeatDiffusionMetric.h"

#include "itkMultiThreaderBase.h"

namespace
{
using namespace shapeton;

constexpr int mostFacesForPairs = 60000;

void
CompareWithPairs(const SurfaceLaplacian & laplacian, const HeatDiffusionMetric & metric, double exactSeconds)
{
  for (const int pairs : { 50, 200, 500 })
  {
    const Stopwatch       watch;
    const SurfaceSpectrum spectrum = ComputeSurfaceSpectrum(laplacian, pairs);
    const auto            truncated = TruncatedHeatDiffusionMetric(laplacian, spectrum, metric.time, pairs);
    const double          seconds = watch.Seconds();
    std::printf(
      "  %d eigenpairs: %.2f s, last lambda t %.1f\n", pairs, seconds, spectrum.eigenvalues[pairs - 1] * metric.time);
    if (pairs < 500)
    {
      PrintBound(pairs == 50 ? "time of exact / time of 50 eigenpairs" : "time of exact / time of 200 eigenpairs",
                 exactSeconds / seconds,
                 pairs == 50 ? 2.0 : 0.25);
    }
  }
}

void
Run(int faces)
{
  testsurfaces::ColonTubeOptions options;
  options.faces = faces;
  options.length = std::min(1500.0, 1500.0 * faces / 55000.0); // small tubes are short, so t matches their radius
  const auto                tube = testsurfaces::MakeColonTube(options);
  const SurfaceConnectivity connectivity(tube.mesh);
  const SurfaceLaplacian    laplacian = MakeSurfaceLaplacian(connectivity, tube.mesh.V);
  const Eigen::VectorXd     lengths = EdgeLengths(connectivity, tube.mesh.V);
  const bool                hasPairs = faces <= mostFacesForPairs;
  const double              t =
    hasPairs ? 32.0 * std::pow(lengths.mean(), 2) : DefaultDiffusionTime(lengths.mean(), tube.narrowestRadius);

  const Stopwatch                 setUp;
  const HeatDiffusionMetricSolver solver(laplacian);
  const double                    setUpSeconds = setUp.Seconds();
  const Stopwatch                 computation;
  const HeatDiffusionMetric       metric = solver.Compute(t);
  const double                    seconds = computation.Seconds();
  std::printf("\n%d faces, t = %.1f mm^2 = %.1f h^2, %u threads\n",
              tube.mesh.NumberOfFaces(),
              t,
              t / std::pow(lengths.mean(), 2),
              itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads());
  std::printf(
    "  order and symbolic analysis %.3f s, %d poles %.3f s; factor %.1f million, %.2f billion products for each "
    "pole; peak %.0f MB\n",
    setUpSeconds,
    HeatDiffusionMetricSolver::defaultPoles,
    seconds,
    1e-6 * static_cast<double>(solver.Inversion().Symbolic().FactorElements()),
    1e-9 * solver.Inversion().Symbolic().Products(),
    PeakMegabytes());
  if (hasPairs)
  {
    CompareWithPairs(laplacian, metric, setUpSeconds + seconds);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  for (const int number : NumbersOfFaces(argc, argv, { 12000, 55000, 200000, 1000000 }))
  {
    Run(number);
  }
  return 0;
}
