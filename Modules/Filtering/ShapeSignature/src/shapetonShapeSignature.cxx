#include "shapetonShapeSignature.h"

#include "shapetonExceptions.h"
#include "shapetonLabelShapes.h"
#include "shapetonLevelSurface.h"
#include "shapetonObjectHeat.h"
#include "shapetonPi.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceSpectrum.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shapeton
{
namespace
{

/** The boundary of an object, in voxels. */
SurfaceMesh
BoundaryOf(ShapeOccupancy & occupancy)
{
  // Values equal to the level would produce degenerate faces.
  constexpr float level = 0.5F, leastStep = 0.001F;
  for (float & value : occupancy.values)
  {
    value = value >= level ? std::max(value, level + leastStep) : std::min(value, level - leastStep);
  }
  return LevelSurface(occupancy.values, occupancy.grid.size, level);
}

std::array<double, ShapeSignature::NumberOfEigenvalues>
SpectrumOf(const SurfaceMesh & shell)
{
  constexpr int pairs = static_cast<int>(ShapeSignature::NumberOfEigenvalues) + 1; // including the 0
  const auto    laplacian = MakeSurfaceLaplacian(SurfaceConnectivity(shell), shell.V);
  const auto    eigenvalues = ComputeSurfaceSpectrum(laplacian, pairs).eigenvalues;
  const double  area = laplacian.mass.sum();
  std::array<double, ShapeSignature::NumberOfEigenvalues> spectrum{};
  for (int i = 1; i < pairs; ++i)
  {
    spectrum[i - 1] = eigenvalues[i] * area;
  }
  return spectrum;
}

void
RequireVoxels(const VoxelRuns & shape)
{
  const std::size_t voxels = CountVoxels(shape);
  if (voxels < ShapeSignature::LeastVoxels)
  {
    throw InputError("it has " + std::to_string(voxels) + " voxels, fewer than the " +
                     std::to_string(ShapeSignature::LeastVoxels) + " that a signature needs");
  }
}
} // namespace

const ShapeSignature::Curve &
ShapeSignature::Times()
{
  static const Curve times = [] {
    Curve  halfOctaves{};
    double time = 0.004;
    for (double & entry : halfOctaves)
    {
      entry = time;
      time *= std::sqrt(2.0);
    }
    return halfOctaves;
  }();
  return times;
}

ShapeSignature
ComputeShapeSignature(const VoxelRuns & shape, const itk::ImageBase<3> * image)
{
  const auto size = image->GetBufferedRegion().GetSize();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (static_cast<itk::SizeValueType>(shape.size[axis]) != size[axis])
    {
      throw std::invalid_argument("The shape and the image have different sizes");
    }
  }
  RequireVoxels(shape);
  const ShapeMoments moments = MomentsOf(shape, image);
  const double       radius = std::cbrt(0.75 * moments.volume / Pi);
  const double       spacing = radius / ShapeSignature::RadiusInVoxels;
  ShapeOccupancy     occupancy = OccupancyOf(shape, image, moments, spacing);

  constexpr double      unit = ShapeSignature::RadiusInVoxels * ShapeSignature::RadiusInVoxels; // r^2 in squared voxels
  ShapeSignature::Curve times = ShapeSignature::Times();
  std::for_each(times.begin(), times.end(), [](double & time) { time *= unit; });
  ShapeSignature signature;
  signature.volume = moments.volume;
  signature.elongation = moments.deviations[0] / moments.deviations[1];
  signature.flatness = moments.deviations[1] / moments.deviations[2];
  signature.remainingHeat = RemainingHeat(occupancy, times);
  signature.displacement = MeanSquareDisplacement(occupancy, times);
  std::for_each(signature.displacement.begin(), signature.displacement.end(), [](double & square) { square /= unit; });
  const SurfaceMesh boundary = BoundaryOf(occupancy);
  signature.surface = SurfaceArea(boundary.V, boundary.F) * spacing * spacing;
  signature.spectrum = SpectrumOf(OuterShell(boundary));
  return signature;
}
} // namespace shapeton
