#ifndef shapetonHeatParameterChoice_h
#define shapetonHeatParameterChoice_h

#include "shapetonCumulativeHeatDiffusion.h"

#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** Parameters of cumulative heat diffusion that the caller has fixed; the others are chosen. p is relative to the
 * window: if p is given without a window, the window is the range of the volume, without smoothing.
 * \ingroup ShapetonHeat */
struct GivenHeatParameters
{
  std::optional<std::array<double, 2>> intensityWindow;
  std::optional<double>                p;
  std::optional<double>                smoothing;
  std::optional<std::uint64_t>         timeSteps;
};

/** The window, and those parameters of the options whose names are among `names`. \ingroup ShapetonHeat */
ShapetonHeat_EXPORT GivenHeatParameters
GivenAmong(const std::vector<std::string> & names, const VolumeDiffusionOptions & options);

/** Parameters chosen from the data, and why.
 * \ingroup ShapetonHeat */
struct ShapetonHeat_EXPORT HeatParameterChoice
{
  /** Sets the four parameters, except for the window if the volume was constant. */
  void
  ApplyTo(VolumeDiffusionOptions & options) const;

  std::array<double, 2> intensityWindow{ { 0.0, 0.0 } };
  double                p{ 0.0 };
  double                smoothing{ 0.0 }; ///< mm
  std::uint64_t         timeSteps{ 0 };
  /** Number of regions that these parameters yield on the reduced volume, by MeasureCoherence(); 0 if no trial was
   * needed. */
  double regions{ 0.0 };
  /** Reasons, in words; empty for given values. */
  std::string windowReason, pReason, smoothingReason, timeReason;
};

/** Chooses window, p, smoothing and number of steps such that objects become separate classes (the source leaves it to
 * future work, 7.2.2).
 *
 * The volume is averaged over blocks to at most 128^3 voxels. Window, p and time are varied on this copy, and the
 * combination that shows the most regions, by MeasureCoherence(), is used. If the smallest spacing of the copy is f
 * times that of the volume, the volume gets f times the p of the copy, because its gradient per voxel is 1/f of the
 * copy's, and f^2 times the number of steps.
 *
 * Windows: for CT, soft tissue (-160 to 240 HU); otherwise, and if that shows hardly more than one region, four
 * windows: from the mean or the upper end of the darkest of three intensity classes (Otsu 1979) to the mean or the
 * lower end of the brightest. If the modality of the volume is unknown, values that look like HU count as CT. p: 1/p is
 * one or two times the median difference between neighbors inside the window. Smoothing: 0.35 times the smallest
 * spacing of the copy if noise would insulate voxels.
 *
 * `options` supplies the conductance, the device and so on. Throws as DiffuseCumulativeHeat(). For an image in a
 * pipeline, update it first: `filter->UseParameters(ChooseHeatParameters(VolumeView(image), filter->GetOptions()))`.
 *
 * \ingroup ShapetonHeat */
ShapetonHeat_EXPORT HeatParameterChoice
ChooseHeatParameters(const VolumeView &                     volume,
                     const CumulativeHeatDiffusionOptions & options = {},
                     const GivenHeatParameters &            given = {},
                     const Progress &                       progress = {});
} // namespace shapeton

#endif
