#ifndef shapetonTransferFunctionPicture_h
#define shapetonTransferFunctionPicture_h

#include "HeatViewsExport.h"

#include "itkImage.h"
#include "shapetonPicture.h"
#include "shapetonShapeTransferFunction.h"
#include "shapetonSliceMontage.h"
#include "shapetonVolumeRendering.h"

#include <string>

namespace shapeton
{
/** What a transfer function shows of a heat volume, on one page: the rendered volume from the front (turned a little,
 * so that depth is seen), its lines with the number of voxels of each, and three slices of the grey image with the
 * lines' colours. 1200 pixels wide. `title` is one line. `renderer` draws the volume, where given; it must be of the
 * same heat and transfer function. Throws std::invalid_argument when the images differ in size. \ingroup HeatViews */
HeatViews_EXPORT Picture::Pointer
                 DrawTransferFunction(const itk::Image<float, 3> *  grey,
                                      const itk::Image<float, 3> *  heat,
                                      const ShapeTransferFunction & transferFunction,
                                      const std::string &           title,
                                      const IntensityWindow &       window = {},
                                      const ShapeQuantity &         quantity = {},
                                      const VolumeRenderer *        renderer = nullptr);

/** The number of voxels in each line.
 * \ingroup HeatViews */
HeatViews_EXPORT std::vector<std::uint64_t>
                 CountVoxelsOfLines(const itk::Image<float, 3> * heat, const ShapeTransferFunction & transferFunction);
} // namespace shapeton

#endif
