// Heat diffusion distances of all edges of a surface: exactly, without computing eigenpairs, and from the first 100
// eigenpairs. Usage: ExampleSurfaceHeat SURFACE
#include "shapetonHeatDiffusionMetric.h"
#include "shapetonSurfaceReader.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " SURFACE\n";
    return 2;
  }
  const shapeton::Surface             surface = shapeton::ReadSurface(argv[1]);
  const shapeton::SurfaceConnectivity connectivity(surface.mesh);
  const shapeton::SurfaceLaplacian    laplacian = shapeton::MakeSurfaceLaplacian(connectivity, surface.mesh.V);
  const shapeton::SurfaceSpectrum     spectrum = shapeton::ComputeSurfaceSpectrum(laplacian, 100);
  const double                        time = 40.0 / spectrum.eigenvalues[50]; // mm^2

  const Eigen::VectorXd all = shapeton::HeatDiffusionMetricSolver(laplacian).Compute(time).edgeLengths;
  const Eigen::VectorXd some = shapeton::TruncatedHeatDiffusionMetric(laplacian, spectrum, time, 100).edgeLengths;
  std::cout << all.size() << " edges, " << spectrum.NumberOfPairs() << " eigenvalues up to "
            << spectrum.eigenvalues.maxCoeff() << " per mm^2; greatest relative difference at " << time
            << " mm^2: " << ((some - all).array() / all.array()).abs().maxCoeff() << '\n';
}
