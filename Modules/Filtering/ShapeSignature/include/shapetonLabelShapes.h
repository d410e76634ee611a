#ifndef shapetonLabelShapes_h
#define shapetonLabelShapes_h

#include "ShapetonShapeSignatureExport.h"
#include "shapetonVoxelRuns.h"

#include "itkImage.h"

namespace shapeton
{
/** A label map as read from volume files: integers, 0 for the background. \ingroup ShapetonShapeSignature */
using LabelMap = itk::Image<float, 3>;

/** The labels of a label map, ascending, excluding 0. Throws InputError for values that are not integers from 0 to
 * 65535, and if there is no label. \ingroup ShapetonShapeSignature */
ShapetonShapeSignature_EXPORT std::vector<int>
                              LabelsOf(const LabelMap * labels);

/** The voxels of a label. \ingroup ShapetonShapeSignature */
ShapetonShapeSignature_EXPORT VoxelRuns
VoxelsOfLabel(const LabelMap * labels, int label);

/** The face-connected components of a shape that have at least this number of voxels, largest first.
 * \ingroup ShapetonShapeSignature */
ShapetonShapeSignature_EXPORT std::vector<VoxelRuns>
                              ComponentsOf(const VoxelRuns & shape, std::size_t leastVoxels = 1);

/** The number of voxels of a shape. \ingroup ShapetonShapeSignature */
ShapetonShapeSignature_EXPORT std::size_t
                              CountVoxels(const VoxelRuns & shape);
} // namespace shapeton

#endif
