#include "shapetonHeatKernel.h"

#include "shapetonDiffusionTime.h"
#include "shapetonExceptions.h"

#include <algorithm>

namespace shapeton
{
namespace
{
void
CheckVertex(const SurfaceSpectrum & spectrum, int vertex)
{
  if (vertex < 0 || vertex >= spectrum.eigenfunctions.rows())
  {
    throw InputError("vertex " + std::to_string(vertex) + " does not exist; there are " +
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

/** \equation{5.3} */
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

std::vector<double>
HeatKernelSignatureTimes(const SurfaceSpectrum & spectrum, int number)
{
  const Eigen::VectorXd & values = spectrum.eigenvalues;
  const double            highest = values.size() > 0 ? values[values.size() - 1] : 0.0;
  const double            rounding = 1e-9 * highest; // rounding level of a zero eigenvalue
  const double * const    lowest =
    std::find_if(values.data(), values.data() + values.size(), [&](double value) { return value > rounding; });
  if (highest <= 0.0 || *lowest >= highest)
  {
    throw InputError("too few eigenpairs to derive time scales; compute more, or specify the times");
  }
  const double        factor = 4.0 * std::log(10.0);
  std::vector<double> times;
  for (int i = 0; i < number; ++i)
  {
    const double share = number > 1 ? static_cast<double>(i) / (number - 1) : 0.0;
    times.push_back(factor / highest * std::pow(highest / *lowest, share));
  }
  return times;
}

double
ShareOfLastPair(const SurfaceSpectrum & spectrum, double t)
{
  RequireDiffusionTime(t);
  return std::exp(-spectrum.eigenvalues[spectrum.NumberOfPairs() - 1] * t);
}

/** \equation{5.5} */
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
} // namespace shapeton
