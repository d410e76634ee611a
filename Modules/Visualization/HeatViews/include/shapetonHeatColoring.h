#ifndef shapetonHeatColoring_h
#define shapetonHeatColoring_h

#include "ShapetonHeatViewsExport.h"

#include "shapetonHeatAxis.h"
#include "shapetonHeatClasses.h"
#include "shapetonShapeTransferFunction.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** Color of a class in pictures, tables and files: ClassColor() of its label, gray for the surroundings.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT RGBColor
ColorOfClass(const HeatClass & heatClass);

/** "class 3: 0.31 to 0.42", the range of its heat; "class 4: incoherent" or "class 1: surroundings" for those that
 * pictures do not show. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT std::string
                         NameOfClass(const HeatClass & heatClass);

/** Color of a voxel by its heat; empty for an uncolored voxel.
 * \ingroup ShapetonHeatViews */
using HeatColoring = std::function<std::optional<RGBColor>(float)>;

/** Colors all heat values except the background (below the first bin of HeatHistogram) by axis position.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT HeatColoring
ColorByHeat(const HeatAxis & axis);

/** Colors voxels by the lines of a transfer function that are not transparent.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT HeatColoring
ColorByLine(const ShapeTransferFunction & transferFunction);
} // namespace shapeton

#endif
