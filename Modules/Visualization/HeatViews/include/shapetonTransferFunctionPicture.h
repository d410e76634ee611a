#ifndef shapetonTransferFunctionPicture_h
#define shapetonTransferFunctionPicture_h

#include "ShapetonHeatViewsExport.h"

#include "itkImage.h"
#include "shapetonPicture.h"
#include "shapetonShapeTransferFunction.h"
#include "shapetonSliceMontage.h"
#include "shapetonVolumeRendering.h"

#include <string>

namespace shapeton
{
/** One page that shows a transfer function on a heat volume: the volume rendered from the front, turned slightly for
 * depth, its lines with their voxel counts, and three slices of the gray image with the colors of the lines. 1200
 * pixels wide. `title` is one line. `renderer`, if given, draws the volume; it must use the same heat and transfer
 * function. Throws std::invalid_argument if the images differ in size. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT Picture::Pointer
                         DrawTransferFunction(const itk::Image<float, 3> *  gray,
                                              const itk::Image<float, 3> *  heat,
                                              const ShapeTransferFunction & transferFunction,
                                              const std::string &           title,
                                              const IntensityWindow &       window = {},
                                              const ShapeQuantity &         quantity = {},
                                              const VolumeRenderer *        renderer = nullptr);

/** The number of voxels in each line.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT std::vector<std::uint64_t>
CountVoxelsOfLines(const itk::Image<float, 3> * heat, const ShapeTransferFunction & transferFunction);
} // namespace shapeton

#endif
