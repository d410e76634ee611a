#include "shapetonShapeComponents.h"
#include "shapetonExceptions.h"

#include "shapetonDisjointSets.h"
#include "shapetonPi.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

using VoxelSets = DisjointSets<std::uint32_t>;

/** The smallest voxel index represents its set. */
VoxelSets
JoinVoxels(const VolumeGradientOperator & op)
{
  const auto &                     grid = op.GetGrid();
  const auto &                     size = grid.GetSize();
  VoxelSets                        sets(grid.GetNumberOfVoxels());
  const std::array<std::size_t, 3> strides = { 1, size[0], size[0] * size[1] };
  std::uint32_t                    voxel = 0;
  for (std::size_t z = 0; z < size[2]; ++z)
  {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      const std::size_t row = grid.GetRow(y, z);
      for (std::size_t x = 0; x < size[0]; ++x, ++voxel)
      {
        const std::array<bool, 3> inside = { x + 1 < size[0], y + 1 < size[1], z + 1 < size[2] };
        for (unsigned int axis = 0; axis < 3; ++axis)
        {
          if (inside[axis] && op.GetConductances(axis)[row + x] > 0.0F)
          {
            sets.Join(voxel, static_cast<std::uint32_t>(voxel + strides[axis]));
          }
        }
      }
    }
  }
  return sets;
}

/** For each voxel the number of its component among the large ones, or none. */
struct Labeling
{
  std::vector<std::uint32_t>  labels;
  std::vector<ShapeComponent> components;
};

Labeling
LabelLargeComponents(VoxelSets & sets, const std::array<std::size_t, 3> & size, std::uint64_t minimumVoxels)
{
  Labeling          labeling;
  const std::size_t number = size[0] * size[1] * size[2];
  auto &            labels = labeling.labels;
  labels.assign(number, 0); // first the sizes, at the roots
  for (std::uint32_t voxel = 0; voxel < number; ++voxel)
  {
    ++labels[sets.Find(voxel)];
  }
  for (std::uint32_t voxel = 0; voxel < number; ++voxel) // a root precedes its other voxels
  {
    const std::uint32_t root = sets.Find(voxel);
    if (root != voxel)
    {
      labels[voxel] = labels[root];
    }
    else if (labels[voxel] < minimumVoxels)
    {
      labels[voxel] = none;
    }
    else
    {
      ShapeComponent component;
      component.index = { voxel % size[0], voxel / size[0] % size[1], voxel / (size[0] * size[1]) };
      component.voxels = labels[voxel];
      component.closed = true;
      labels[voxel] = static_cast<std::uint32_t>(labeling.components.size());
      labeling.components.push_back(component);
    }
  }
  return labeling;
}

void
MeasureHeat(Labeling & labeling, const VolumeGradientOperator & op, const PaddedField & initialHeat)
{
  const auto & grid = op.GetGrid();
  const auto & size = grid.GetSize();
  std::size_t  voxel = 0;
  for (std::size_t z = 0; z < size[2]; ++z)
  {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      const float * const heat = initialHeat.GetData() + grid.GetRow(y, z);
      const bool          border = z == 0 || z + 1 == size[2] || y == 0 || y + 1 == size[1];
      for (std::size_t x = 0; x < size[0]; ++x, ++voxel)
      {
        if (labeling.labels[voxel] != none)
        {
          auto & component = labeling.components[labeling.labels[voxel]];
          component.convergedHeat += heat[x];
          component.closed &= !(border || x == 0 || x + 1 == size[0]);
        }
      }
    }
  }
  for (auto & component : labeling.components)
  {
    component.convergedHeat = component.closed ? component.convergedHeat / component.voxels : 0.0;
  }
}

/** Adds, for each closed component, area = 2 sum_d weight_d crossings_d (cross-section of a line in direction d):
 * by Cauchy-Crofton the mean over all directions of twice the number of crossings per unit cross-section. */
void
MeasureArea(Labeling & labeling, const std::array<std::size_t, 3> & size, const std::array<double, 3> & spacing)
{
  const auto   weights = CroftonWeights(spacing);
  const double voxelVolume = spacing[0] * spacing[1] * spacing[2];
  const auto   sizeOf = [&size](unsigned int axis) { return static_cast<std::ptrdiff_t>(size[axis]); };
  for (unsigned int d = 0; d < weights.size(); ++d)
  {
    const auto & offset = CroftonOffsets()[d];
    const double length = std::hypot(offset[0] * spacing[0], offset[1] * spacing[1], offset[2] * spacing[2]);
    const double area = 2.0 * weights[d] * voxelVolume / length;
    const auto   step = offset[0] + sizeOf(0) * (offset[1] + sizeOf(1) * offset[2]);
    // A closed component does not touch the border: its neighbors exist.
    for (std::ptrdiff_t z = 1; z + 1 < sizeOf(2); ++z)
    {
      for (std::ptrdiff_t y = 1; y + 1 < sizeOf(1); ++y)
      {
        const std::ptrdiff_t first = (z * sizeOf(1) + y) * sizeOf(0) + 1;
        for (std::ptrdiff_t voxel = first; voxel < first + sizeOf(0) - 2; ++voxel)
        {
          const std::uint32_t label = labeling.labels[voxel];
          if (label == none || !labeling.components[label].closed)
          {
            continue;
          }
          const int crossings = (labeling.labels[voxel + step] != label) + (labeling.labels[voxel - step] != label);
          labeling.components[label].surfaceArea += area * crossings;
        }
      }
    }
  }
}
} // namespace

const std::array<std::array<int, 3>, 13> &
CroftonOffsets()
{
  static const std::array<std::array<int, 3>, 13> offsets = { { { 1, 0, 0 },
                                                                { 0, 1, 0 },
                                                                { 0, 0, 1 },
                                                                { 1, 1, 0 },
                                                                { 1, -1, 0 },
                                                                { 1, 0, 1 },
                                                                { 1, 0, -1 },
                                                                { 0, 1, 1 },
                                                                { 0, 1, -1 },
                                                                { 1, 1, 1 },
                                                                { 1, 1, -1 },
                                                                { 1, -1, 1 },
                                                                { 1, -1, -1 } } };
  return offsets;
}

std::array<double, 13>
CroftonWeights(const std::array<double, 3> & spacing)
{
  std::array<std::array<double, 3>, 13> axes{};
  for (unsigned int d = 0; d < axes.size(); ++d)
  {
    double norm = 0.0;
    for (unsigned int k = 0; k < 3; ++k)
    {
      axes[d][k] = CroftonOffsets()[d][k] * spacing[k];
      norm += axes[d][k] * axes[d][k];
    }
    for (double & component : axes[d])
    {
      component /= std::sqrt(norm);
    }
  }
  // Evenly distributed directions (a spherical Fibonacci lattice), each assigned to its nearest axis.
  constexpr int          samples = 40000;
  const double           goldenAngle = Pi * (3.0 - std::sqrt(5.0));
  std::array<double, 13> weights{};
  for (int i = 0; i < samples; ++i)
  {
    const double                z = (i + 0.5) / samples; // a hemisphere is enough
    const double                r = std::sqrt(1.0 - z * z);
    const std::array<double, 3> direction = { r * std::cos(i * goldenAngle), r * std::sin(i * goldenAngle), z };
    unsigned int                nearest = 0;
    double                      best = -1.0;
    for (unsigned int d = 0; d < axes.size(); ++d)
    {
      const double cosine = std::abs(axes[d][0] * direction[0] + axes[d][1] * direction[1] + axes[d][2] * direction[2]);
      if (cosine > best)
      {
        best = cosine;
        nearest = d;
      }
    }
    weights[nearest] += 1.0 / samples;
  }
  return weights;
}

std::vector<ShapeComponent>
FindShapeComponents(const VolumeGradientOperator & volumeGradient,
                    const PaddedField &            initialHeat,
                    const std::array<double, 3> &  spacing,
                    std::uint64_t                  minimumVoxels)
{
  const auto & size = volumeGradient.GetGrid().GetSize();
  if (volumeGradient.GetGrid().GetNumberOfVoxels() >= none)
  {
    throw InputError("the volume has more than 2^32 - 2 voxels; crop it");
  }
  Labeling labeling;
  {
    VoxelSets sets = JoinVoxels(volumeGradient);
    labeling = LabelLargeComponents(sets, size, std::max<std::uint64_t>(1, minimumVoxels));
  }
  MeasureHeat(labeling, volumeGradient, initialHeat);
  MeasureArea(labeling, size, spacing);
  for (auto & component : labeling.components)
  {
    component.volume = component.voxels * spacing[0] * spacing[1] * spacing[2];
    component.normalizedHeat = component.surfaceArea / (6.0 * std::pow(component.volume, 2.0 / 3.0));
  }
  std::stable_sort(labeling.components.begin(), labeling.components.end(), [](const auto & a, const auto & b) {
    return a.voxels > b.voxels;
  });
  return labeling.components;
}
} // namespace shapeton
