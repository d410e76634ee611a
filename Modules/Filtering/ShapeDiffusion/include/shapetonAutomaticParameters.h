#ifndef shapetonAutomaticParameters_h
#define shapetonAutomaticParameters_h

#include "ShapeDiffusionExport.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** A value of p chosen from the data, and why.
 * \ingroup ShapeDiffusion */
struct AutomaticP
{
  double p{ 7.0 };
  /** Standard deviation of the difference of neighbours that noise alone makes, in units of the intensity window. */
  double noise{ 0.0 };
  /** Lower quartile of the half gradients across edges, in units of the intensity window. */
  double      edgeContrast{ 0.0 };
  std::string reason;
};

/** Chooses p so that edges insulate and noise does not: 1 / p is the geometric mean of edgeContrast and of what noise
 * reaches, four times its standard deviation or a quarter of edgeContrast; p lies in [1, 50] (the future work of 7.2.2
 * of the dissertation). Noise is 3.138 times the lower quartile of the half gradients that are not 0, provided that at
 * least one pair of neighbours in ten differs at all; edges are pairs whose half gradient exceeds four times the noise
 * and both half gradients beside it on the same axis. `spacing` along the axes in any unit; half gradients are taken as
 * in VolumeGradientOperator. \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT AutomaticP
ChooseP(const float *                      intensities,
        const std::array<std::size_t, 3> & size,
        const std::array<double, 3> &      spacing,
        double                             lower,
        double                             upper);

/** How the recorded time steps lie on the time axis.
 * \ingroup ShapeDiffusion */
enum class SnapshotSpacing
{
  Linear,
  Logarithmic
};

/** At most `number` distinct steps from 0 to `last`, both included: fewer where rounding makes steps equal, as it does
 * with the first ones of a logarithmic spacing (512 to 100,000 give 388).
 * \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT std::vector<std::uint64_t>
                      MakeSnapshotSteps(std::uint64_t last, std::size_t number, SnapshotSpacing spacing);
} // namespace shapeton

#endif
