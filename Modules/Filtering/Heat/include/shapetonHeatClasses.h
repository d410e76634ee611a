#ifndef shapetonHeatClasses_h
#define shapetonHeatClasses_h

#include "ShapetonHeatExport.h"
#include "shapetonHeatHistogram.h"

#include <cstdint>

namespace shapeton
{
/** A class of voxels with similar heat: one line of the heat histogram (dissertation 2.3.3).
 * \ingroup ShapetonHeat */
struct HeatClass
{
  /** 0 is the background, 1 the class with the lowest heat; similar classes have adjacent numbers. */
  unsigned int label{ 0 };
  /** The class contains lowerHeat <= heat < upperHeat. */
  double        lowerHeat{ 0.0 };
  double        upperHeat{ 0.0 };
  double        meanHeat{ 0.0 };
  std::uint64_t voxels{ 0 };
  double        volume{ 0.0 }; ///< mm^3
  /** Fraction of the border voxels of the volume that belong to the class. If it is above one half, the class consists
   * of the surroundings of the objects, which lose heat through the border. */
  double borderShare{ 0.0 };
  /** Number of converged components of at least 27 voxels in the class that are closed by edges of zero weight. */
  std::uint64_t components{ 0 };
  /** Scale-normalized counterpart of the heat (an isoperimetric number): mean over the class's components, weighted by
   * voxels; 0 if the class contains no closed component. */
  double normalizedHeat{ 0.0 };
  /** How well the class is a region of the image, in [0, 1]: see MeasureCoherence(). */
  double coherence{ 0.0 };
};
} // namespace shapeton

#endif
