#ifndef shapetonAutomaticParameters_h
#define shapetonAutomaticParameters_h

#include "shapetonVolumeGradientOperator.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** A value of p chosen from the data, and the reason.
 * \ingroup ShapetonHeat */
struct AutomaticP
{
  double p{ VolumeGradientOptions().p };
  /** Standard deviation of the difference between neighbors due to noise, in units of the intensity window. */
  double noise{ 0.0 };
  /** Lower quartile of the half gradients across edges, in units of the intensity window. */
  double      edgeContrast{ 0.0 };
  std::string reason;
};

/** Chooses p such that edges insulate and noise does not (future work in 7.2.2 of the dissertation). 1 / p is the
 * geometric mean of edgeContrast and a noise bound. The bound is four times the standard deviation of the noise, but at
 * least a quarter of edgeContrast. p is clamped to [1, 50]. Noise is 3.138 times the lower quartile of the nonzero half
 * gradients, provided that at least one in ten pairs of neighbors differs. Edges are pairs whose half gradient exceeds
 * four times the noise and both adjacent half gradients on the same axis. Half gradients (see VolumeGradientOperator)
 * are relative to the intensity window of the options. \ingroup ShapetonHeat */
ShapetonHeat_EXPORT AutomaticP
ChooseP(const VolumeView & volume, const VolumeGradientOptions & options);

/** Spacing of the recorded time steps on the time axis.
 * \ingroup ShapetonHeat */
enum class SnapshotSpacing
{
  Linear,
  Logarithmic
};

/** At most `number` distinct steps from 0 to `last`, both included; fewer if steps coincide after rounding, as at the
 * start of a logarithmic spacing (512 steps to 100,000 yield 388).
 * \ingroup ShapetonHeat */
ShapetonHeat_EXPORT std::vector<std::uint64_t>
                    MakeSnapshotSteps(std::uint64_t last, std::size_t number, SnapshotSpacing spacing);
} // namespace shapeton

#endif
