#ifndef shapetonSliceChoice_h
#define shapetonSliceChoice_h

#include "ShapetonHeatViewsExport.h"

#include "itkImage.h"
#include "shapetonHeatObjects.h"
#include "shapetonShapeTransferFunction.h"

namespace shapeton
{
/** The voxel whose three slices show most parts: the lines of a transfer function that are not transparent, or the
 * labels of a label map.
 *
 * Along each axis, the slice with the largest sum over the parts of cbrt(V) * sqrt(a / A), where V is the number of
 * voxels of the part, a that in the slice, and A that in the slice with most of them. So a part counts by its diameter,
 * and it counts nearly in full wherever a good part of its largest section is visible. Of equal slices, the one nearest
 * to the middle. Volumes of more than 4 million voxels are sampled.
 * \ingroup ShapetonHeatViews */
///@{
ShapetonHeatViews_EXPORT itk::Index<3>
                         CutThroughParts(const itk::Image<float, 3> * values, const ShapeTransferFunction & lines);
ShapetonHeatViews_EXPORT itk::Index<3>
                         CutThroughParts(const HeatObjectList::LabelImage * labels);
///@}
} // namespace shapeton

#endif
