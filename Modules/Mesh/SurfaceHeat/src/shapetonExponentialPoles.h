#ifndef shapetonExponentialPoles_h
#define shapetonExponentialPoles_h

#include <complex>
#include <vector>

namespace shapeton
{
/** A rational function for exp(-x), x >= 0: Re sum residue / (x + pole). */
struct ExponentialPoles
{
  struct Term
  {
    std::complex<double> pole; ///< in the upper half plane; the real part includes its conjugate
    std::complex<double> residue;
  };
  std::vector<Term> terms;
  /** Bound on |r(x) - exp(-x)| (1 + x)^2. */
  double error;
};

/** \pre HeatDiffusionMetricSolver::leastPoles <= pairs <= mostPoles */
const ExponentialPoles &
GetExponentialPoles(int pairs);
} // namespace shapeton

#endif
