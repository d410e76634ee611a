#ifndef shapetonExplorerInfo_h
#define shapetonExplorerInfo_h

#include "ShapetonHeatViewsExport.h"
#include "shapetonHeatExplorer.h"
#include "shapetonHeatObjects.h"
#include "shapetonJsonForward.h"

#include <cstddef>
#include <vector>

namespace shapeton
{
/** Maximum number of voxels on the pages of HeatExplorer and LiveExplorer, so that they open within seconds; larger
 * volumes are subsampled.
 * \ingroup ShapetonHeatViews */
constexpr std::size_t ExplorerVoxels = std::size_t{ 1 } << 25;

/** Data on volume and views for the script of the heat explorer, independent of the heat. A volume of more than
 * `greatestVoxels` voxels is subsampled. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT Json
InfoOf(const HeatExplorerContent & content, std::size_t greatestVoxels = ExplorerVoxels);

/** The quantity and the lines for that script. \ingroup ShapetonHeatViews */
///@{
ShapetonHeatViews_EXPORT Json
JsonOf(const ShapeQuantity & quantity);
ShapetonHeatViews_EXPORT Json
JsonOf(const ShapeTransferFunction & transferFunction);
///@}

/** Number (from 1), ColorOfObject(), parent, heat, voxels, volume, center and probability of each object, for the
 * scripts of the heat explorer and the live session. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT Json
JsonOf(const HeatObjectList & objects);
} // namespace shapeton

#endif
