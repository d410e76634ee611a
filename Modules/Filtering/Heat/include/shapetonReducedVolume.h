#ifndef shapetonReducedVolume_h
#define shapetonReducedVolume_h

#include "ShapetonHeatExport.h"
#include "shapetonVolumeView.h"

#include <array>

namespace shapeton
{
/** A volume averaged to larger voxels, used to try parameters. \ingroup ShapetonHeat */
struct ReducedVolume : VolumeView
{
  double factor{ 1.0 }; ///< its smallest spacing divided by that of the volume
};

/** Reduces a volume to at most 128^3 voxels by averaging over blocks of at least two voxels, which also removes noise.
 * Sides are not reduced below 16 voxels. In a domain, its voxels only are averaged; the domain of the result are the
 * blocks of which at least half of the voxels are in it. \ingroup ShapetonHeat */
ShapetonHeat_EXPORT ReducedVolume
ReduceVolume(const VolumeView & volume);

/** The smallest of three spacings. \ingroup ShapetonHeat */
ShapetonHeat_EXPORT double
SmallestSpacing(const std::array<double, 3> & spacing);
} // namespace shapeton

#endif
