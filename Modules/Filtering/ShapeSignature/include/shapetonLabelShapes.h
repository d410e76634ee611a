#ifndef shapetonLabelShapes_h
#define shapetonLabelShapes_h

#include "ShapeSignatureExport.h"
#include "shapetonVoxelRuns.h"

#include "itkImage.h"

namespace shapeton
{
/** Labels as files of volumes give them: whole numbers, 0 for the background. \ingroup ShapeSignature */
using LabelMap = itk::Image<float, 3>;

/** The labels of a label map, ascending, without 0. Throws InputError for values that are no whole numbers from 0 to
 * 65535, and when there is none. \ingroup ShapeSignature */
ShapeSignature_EXPORT std::vector<int>
                      LabelsOf(const LabelMap * labels);

/** The voxels of a label. \ingroup ShapeSignature */
ShapeSignature_EXPORT VoxelRuns
VoxelsOfLabel(const LabelMap * labels, int label);

/** The parts of a shape that are connected by faces and have at least so many voxels, the largest first.
 * \ingroup ShapeSignature */
ShapeSignature_EXPORT std::vector<VoxelRuns>
                      ComponentsOf(const VoxelRuns & shape, std::size_t leastVoxels = 1);

/** The number of voxels of a shape. \ingroup ShapeSignature */
ShapeSignature_EXPORT std::size_t
                      CountVoxels(const VoxelRuns & shape);
} // namespace shapeton

#endif
