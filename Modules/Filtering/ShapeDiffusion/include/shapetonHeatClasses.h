#ifndef shapetonHeatClasses_h
#define shapetonHeatClasses_h

#include "ShapeDiffusionExport.h"
#include "shapetonHeatHistogram.h"

#include <cstdint>
#include <vector>

namespace shapeton
{
/** A class of voxels with similar heat: one line of the heat histogram (dissertation 2.3.3).
 * \ingroup ShapeDiffusion */
struct HeatClass
{
  /** 0 is the background; 1 the class of least heat; similar classes have neighbouring numbers. */
  unsigned int label{ 0 };
  /** The class holds lowerHeat <= heat < upperHeat. */
  double        lowerHeat{ 0.0 };
  double        upperHeat{ 0.0 };
  double        meanHeat{ 0.0 };
  std::uint64_t voxels{ 0 };
  double        volume{ 0.0 }; ///< mm^3
  /** The share of the voxels at the border of the volume that lie in the class. Where it is above one half, the class
   * is what surrounds the objects, and its heat leaves through the border. */
  double borderShare{ 0.0 };
  /** Number of converged components of at least 27 voxels, closed off by edges of zero weight, in the class. */
  std::uint64_t components{ 0 };
  /** Scale-normalised companion (an isoperimetric number): mean over the class's components, weighted by voxels;
   * 0 when the class holds no closed component. */
  double normalizedHeat{ 0.0 };
};
} // namespace shapeton

#endif
