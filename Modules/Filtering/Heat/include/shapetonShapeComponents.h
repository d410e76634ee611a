#ifndef shapetonShapeComponents_h
#define shapetonShapeComponents_h

#include "shapetonVolumeGradientOperator.h"

#include <cstdint>
#include <vector>

namespace shapeton
{
/** A set of voxels joined by edges of positive weight; diffusion does not mix components.
 * \ingroup ShapetonHeat */
struct ShapeComponent
{
  /** The first voxel of the component, relative to the first voxel of the volume, not to index 0. */
  std::array<std::size_t, 3> index{};
  std::uint64_t              voxels{ 0 };
  double                     volume{ 0.0 }; ///< mm^3
  /** False if the component reaches the boundary of the volume, where heat is lost. */
  bool closed{ false };
  /** The final heat of every voxel: the mean initial heat of a closed component, 0 for an open one. Computed exactly
   * for closed components, without time steps. For a closed binary object it is (cut faces) / (6 voxels). */
  double convergedHeat{ 0.0 };
  double surfaceArea{ 0.0 }; ///< mm^2, see below; 0 for an open component
  /** area / (6 volume^(2/3)), a scale-free shape measure: 1 for a cube (measured with 13 directions: 0.90 to 0.95,
   * depending on rotation), 0.806 for a sphere; 0 for an open component. */
  double normalizedHeat{ 0.0 };
};

/** Finds the components of at least `minimumVoxels` voxels, largest first, by union-find over the edges.
 *
 * The converged heat of a shape decreases with its size (0.75 / radius for a sphere, 1 / side for a cube in voxels)
 * and increases when a cube is rotated (+23 % at 30 degrees). Contrary to 2.3.4 of the dissertation it is invariant
 * neither to scale nor to rotation. normalizedHeat is the scale-free companion, heat * volume^(1/3), with the boundary
 * area measured by the Cauchy-Crofton formula over 13 directions, which makes it nearly rotation-invariant. Use it to
 * compare shapes of different size; use the heat to distinguish objects within one volume.
 *
 * `initialHeat` is computed by VolumeGradientOperator::ComputeInitialHeat; `spacing` in mm.
 * \ingroup ShapetonHeat */
ShapetonHeat_EXPORT std::vector<ShapeComponent>
                    FindShapeComponents(const VolumeGradientOperator & volumeGradient,
                                        const PaddedField &            initialHeat,
                                        const std::array<double, 3> &  spacing,
                                        std::uint64_t                  minimumVoxels);

/** Fraction of the sphere of directions closest to each of the 13 axes through a voxel's neighbors, in the order of
 * CroftonOffsets(); sums to 1. For equal spacings .0916 (faces), .0740 (edges), .0704 (corners).
 * \ingroup ShapetonHeat */
ShapetonHeat_EXPORT std::array<double, 13>
                    CroftonWeights(const std::array<double, 3> & spacing);

ShapetonHeat_EXPORT const std::array<std::array<int, 3>, 13> &
                          CroftonOffsets();
} // namespace shapeton

#endif
