#ifndef shapetonHeatColoring_h
#define shapetonHeatColoring_h

#include "ShapetonHeatViewsExport.h"

#include "shapetonHeatAxis.h"
#include "shapetonHeatClasses.h"
#include "shapetonShapeTransferFunction.h"

#include <functional>
#include <optional>
#include <vector>

namespace shapeton
{
/** Color of a voxel by its heat; empty for an uncolored voxel.
 * \ingroup ShapetonHeatViews */
using HeatColoring = std::function<std::optional<RGBColor>(float)>;

/** Colors all heat values except the background (below the first bin of HeatHistogram) by axis position.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT HeatColoring
ColorByHeat(const HeatAxis & axis);

/** Colors each class except the background by ClassColor(). Heat colors do not distinguish the classes: on the
 * equalized axis, the decreasing heat values of early time steps take most of the space, so classes of late steps share
 * one color.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT HeatColoring
ColorByClass(const std::vector<HeatClass> & classes);

/** Colors voxels by the lines of a transfer function.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT HeatColoring
ColorByLine(const ShapeTransferFunction & transferFunction);
} // namespace shapeton

#endif
