#ifndef shapetonShapeComponents_h
#define shapetonShapeComponents_h

#include "shapetonVolumeGradientOperator.h"

#include <cstdint>
#include <vector>

namespace shapeton
{
/** A set of voxels joined by edges of positive weight: what the diffusion can tell apart for ever.
 * \ingroup ShapeDiffusion */
struct ShapeComponent
{
  /** The component's first voxel, counted from that of the volume, also where the index of an image begins elsewhere.
   */
  std::array<std::size_t, 3> index{};
  std::uint64_t              voxels{ 0 };
  double                     volume{ 0.0 }; ///< mm^3
  /** False when the component reaches the boundary of the volume, through which its heat leaves. */
  bool closed{ false };
  /** The heat that every voxel has in the end: the mean initial heat of a closed component, 0 of an open one. Exact for
   * closed components: no step is taken. For a closed binary object it is (cut faces) / (6 voxels). */
  double convergedHeat{ 0.0 };
  double surfaceArea{ 0.0 }; ///< mm^2, see below; 0 for an open component
  /** area / (6 volume^(2/3)), a number of the shape alone: 1 for a cube (13 directions measure 0.90 to 0.95, by how it
   * is turned), 0.806 for a sphere; 0 for an open component. */
  double normalizedHeat{ 0.0 };
};

/** Finds the components of at least `minimumVoxels` voxels, largest first, by union-find over the edges.
 *
 * The converged heat of a shape shrinks with its size (0.75 / radius for a sphere, 1 / side for a cube in voxels) and
 * grows when a cube is turned (+23 % at 30 degrees): unlike what 2.3.4 of the dissertation says it is invariant neither
 * to scale nor to rotation. normalizedHeat is the scale-free companion, heat * volume^(1/3), with the area of the
 * boundary measured by the Cauchy-Crofton formula over 13 directions so that rotation matters little. Use it to compare
 * shapes of different size; use the heat to tell apart objects of one volume.
 *
 * `initialHeat` as of VolumeGradientOperator::ComputeInitialHeat; `spacing` in mm.
 * \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT std::vector<ShapeComponent>
                      FindShapeComponents(const VolumeGradientOperator & volumeGradient,
                                          const PaddedField &            initialHeat,
                                          const std::array<double, 3> &  spacing,
                                          std::uint64_t                  minimumVoxels);

/** The share of the sphere of directions that is nearest to each of the 13 axes through a voxel's neighbours, in the
 * order of CroftonOffsets(); sums to 1. For equal spacings .0916 (faces), .0740 (edges), .0704 (corners).
 * \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT std::array<double, 13>
                      CroftonWeights(const std::array<double, 3> & spacing);

ShapeDiffusion_EXPORT const std::array<std::array<int, 3>, 13> &
                            CroftonOffsets();
} // namespace shapeton

#endif
