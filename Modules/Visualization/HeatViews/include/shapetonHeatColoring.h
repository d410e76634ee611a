#ifndef shapetonHeatColoring_h
#define shapetonHeatColoring_h

#include "HeatViewsExport.h"

#include "shapetonHeatAxis.h"
#include "shapetonHeatClasses.h"
#include "shapetonShapeTransferFunction.h"

#include <functional>
#include <optional>
#include <vector>

namespace shapeton
{
/** The colour of a voxel by its heat; none where the voxel is not to be coloured.
 * \ingroup HeatViews */
using HeatColoring = std::function<std::optional<RGBColor>(float)>;

/** Every heat but the background's (below the first bin of HeatHistogram) by its place on the axis.
 * \ingroup HeatViews */
HeatViews_EXPORT HeatColoring
ColorByHeat(const HeatAxis & axis);

/** Every class but the background in ClassColor(). Colours by heat would not tell classes apart: on the equalised axis
 * heat that sinks in early time steps takes nearly all room, and classes of late ones share one colour.
 * \ingroup HeatViews */
HeatViews_EXPORT HeatColoring
ColorByClass(const std::vector<HeatClass> & classes);

/** The lines of a transfer function in their colours.
 * \ingroup HeatViews */
HeatViews_EXPORT HeatColoring
ColorByLine(const ShapeTransferFunction & transferFunction);
} // namespace shapeton

#endif
