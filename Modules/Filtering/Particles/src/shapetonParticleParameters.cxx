#include "shapetonParticleParameters.h"

#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace shapeton
{
namespace
{
constexpr double visitsPerVoxel = 20.0;
constexpr double startsPerFeature = 3.0;
constexpr double fewest = 1e3;
constexpr double most = 1e7;

std::string
Rounded(double value)
{
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}
} // namespace

AutomaticShapetons
ChooseShapetons(const std::array<std::size_t, 3> & size,
                const std::array<double, 3> &      spacing,
                double                             featureSize,
                std::uint64_t                      timeSteps)
{
  double side = 0.0;
  double voxels = 1.0;
  double volume = 1.0;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const double extent = static_cast<double>(size[axis]) * spacing[axis];
    side = std::max(side, extent);
    voxels *= static_cast<double>(size[axis]);
    volume *= extent;
  }
  const double smallest = *std::min_element(spacing.begin(), spacing.end());
  if (!(featureSize >= smallest && featureSize <= side))
  {
    throw InputError("the parameter \"featureSize\": a feature of " + Rounded(featureSize) +
                     " mm cannot be resolved in this volume; choose " + Rounded(smallest) + " mm (a voxel) to " +
                     Rounded(side) + " mm (the longest side)");
  }
  AutomaticShapetons chosen;
  chosen.distance = 0.5 * featureSize / side;
  chosen.distanceReason = "half of the feature size, " + Rounded(0.5 * featureSize) +
                          " mm, in units of the longest side, " + Rounded(side) +
                          " mm: a step longer than a feature skips it";
  const double forVoxels = visitsPerVoxel * voxels / static_cast<double>(timeSteps);
  const double forFeatures = startsPerFeature * volume / (featureSize * featureSize * featureSize);
  const double wanted = std::clamp(std::max(forVoxels, forFeatures), fewest, most);
  chosen.shapetons = static_cast<std::uint32_t>(1000.0 * std::ceil(wanted / 1000.0));
  chosen.shapetonsReason =
    wanted == most     ? "the maximum, although more would be better"
    : wanted == fewest ? "the minimum, because the volume is small"
    : forVoxels >= forFeatures
      ? "each voxel gets " + Rounded(visitsPerVoxel) + " visits on average in " + std::to_string(timeSteps) +
          " time steps"
      : Rounded(startsPerFeature) + " start in the volume of a feature, a cube of " + Rounded(featureSize) + " mm";
  return chosen;
}
} // namespace shapeton
