#include "itkHeatKernel.h"

#include "itkDiffusionTime.h"
#include "itkToolError.h"

namespace itk
{
namespace
{
void
CheckVertex(const SurfaceSpectrum & spectrum, int vertex)
{
  if (vertex < 0 || vertex >= spectrum.eigenfunctions.rows())
  {
    throw InputError("there is no vertex " + std::to_string(vertex) + " among " +
                     std::to_string(spectrum.eigenfunctions.rows()));
  }
}

/** exp(-factor lambda t) for each pair. */
Eigen::VectorXd
Decay(const SurfaceSpectrum & spectrum, double t, double factor)
{
  RequireDiffusionTime(t);
  return (-factor * t * spectrum.eigenvalues.array()).exp();
}
} // namespace

double
HeatKernel(const SurfaceSpectrum & spectrum, int p, int q, double t)
{
  CheckVertex(spectrum, p);
  CheckVertex(spectrum, q);
  const auto & phi = spectrum.eigenfunctions;
  return (Decay(spectrum, t, 1.0).transpose().array() * phi.row(p).array() * phi.row(q).array()).sum();
}

Eigen::VectorXd
HeatKernelSignature(const SurfaceSpectrum & spectrum, double t)
{
  return spectrum.eigenfunctions.cwiseAbs2() * Decay(spectrum, t, 1.0);
}

double
DiffusionDistance(const SurfaceSpectrum & spectrum, int p, int q, double t)
{
  CheckVertex(spectrum, p);
  CheckVertex(spectrum, q);
  const Eigen::ArrayXd step = (spectrum.eigenfunctions.row(p) - spectrum.eigenfunctions.row(q)).transpose();
  return std::sqrt((Decay(spectrum, t, 2.0).array() * step.square()).sum());
}

Eigen::VectorXd
DiffusionDistances(const SurfaceSpectrum & spectrum, int p, double t)
{
  CheckVertex(spectrum, p);
  const Eigen::MatrixXd steps = spectrum.eigenfunctions.rowwise() - spectrum.eigenfunctions.row(p);
  return (steps.cwiseAbs2() * Decay(spectrum, t, 2.0)).cwiseSqrt();
}
} // namespace itk
