#ifndef shapetonHeatClasses_h
#define shapetonHeatClasses_h

#include "ShapetonHeatExport.h"
#include "shapetonHeatHistogram.h"

#include <cstdint>
#include <optional>

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
  /** Fraction of the border voxels of the volume that belong to the class. */
  double borderShare{ 0.0 };
  /** Whether the class consists of the surroundings of the objects, which lose heat through the border: it covers more
   * than half of the border. For visits, see AnalyzeVisits(). */
  bool isSurroundings{ false };
  /** Number of converged components of at least 27 voxels in the class that are closed by edges of zero weight. */
  std::uint64_t components{ 0 };
  /** Scale-normalized counterpart of the heat (an isoperimetric number): mean over the class's components, weighted by
   * voxels; 0 if the class contains no closed component. */
  double normalizedHeat{ 0.0 };
  /** How well the class is a region, in [0, 1]: see MeasureCoherence() and MeasureContiguity(). Empty if not measured.
   */
  std::optional<double> coherence{};
};

/** Smallest coherence of a region. In the heat of 16 volumes (CT, MR, microscopy, simulation), the classes of edges and
 * speckle have at most 0.208, the others at least 0.218 and half of them above 0.45: a class near the limit may be
 * either. In densities, speckle has 0. \ingroup ShapetonHeat */
constexpr double LeastCoherence = 0.21;

/** Whether the class is known to be speckle or edges rather than a region. \ingroup ShapetonHeat */
inline bool
IsIncoherent(const HeatClass & heatClass)
{
  return heatClass.coherence && *heatClass.coherence < LeastCoherence;
}
} // namespace shapeton

#endif
