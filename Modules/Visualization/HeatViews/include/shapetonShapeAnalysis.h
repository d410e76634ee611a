#ifndef shapetonShapeAnalysis_h
#define shapetonShapeAnalysis_h

#include "ShapetonHeatViewsExport.h"
#include "shapetonHeatAxis.h"
#include "shapetonHeatClasses.h"
#include "shapetonShapeQuantity.h"

#include "itkImage.h"

#include <cstdint>
#include <vector>

namespace shapeton
{
/** A volume of heat or of visits, with all data that its pictures and tables need.
 * \ingroup ShapetonHeatViews */
struct ShapeAnalysis
{
  ShapeQuantity                         quantity;
  itk::Image<float, 3>::ConstPointer    values;    ///< in [0, 1]
  HeatHistogram                         histogram; ///< one row
  std::vector<HeatClass>                classes;
  itk::Image<unsigned char, 3>::Pointer labels;
  /** Defines the axis and the colors. */
  HeatHistogram axisHistogram;
};

/** Heat after `timeStep`; labels as in AnalyzeVisits(). \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT ShapeAnalysis
AnalyzeHeat(const itk::Image<float, 3> * heat, std::uint64_t timeStep, bool wantLabels = true);

/** Visits of shapetons after `timeStep`, as a density; its axis balances the classes. Labels require a pass over all
 * voxels; without them, the classes have no borderShare, coherence, volume or exact voxel counts. The surroundings are
 * also the class with the fewest visits if it covers more than a tenth of the border: shapetons that left the objects.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT ShapeAnalysis
AnalyzeVisits(const itk::Image<std::uint32_t, 3> * visits, std::uint64_t timeStep, bool wantLabels = true);
} // namespace shapeton

#endif
