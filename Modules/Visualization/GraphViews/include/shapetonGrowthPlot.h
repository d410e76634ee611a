#ifndef shapetonGrowthPlot_h
#define shapetonGrowthPlot_h

#include "ShapetonGraphViewsExport.h"

#include <string>
#include <vector>

namespace shapeton
{
/** A quantity that grows with a radius. \ingroup ShapetonGraphViews */
struct GrowthCurve
{
  /** Quantity and unit. */
  std::string         title;
  std::vector<double> radii;      ///< >= 1, ascending
  std::vector<double> quantities; ///< one per radius, >= 0
};

/** Writes one panel per curve: the quantity, on an axis that starts at 0, against the logarithm of the radius. Equal
 * curves give equal bytes. Throws OutputError. \ingroup ShapetonGraphViews */
ShapetonGraphViews_EXPORT void
WriteGrowthSvg(const std::vector<GrowthCurve> & curves, const std::string & path);
} // namespace shapeton

#endif
