#ifndef itkTransferFunctionPicture_h
#define itkTransferFunctionPicture_h

#include "HeatViewsExport.h"

#include "itkImage.h"
#include "itkPicture.h"
#include "itkShapeTransferFunction.h"
#include "itkSliceMontage.h"

#include <string>

namespace itk
{
/** What a transfer function shows of a heat volume, on one page: the rendered volume from the front (turned a little,
 * so that depth is seen), its lines with the number of voxels of each, and three slices of the grey image with the
 * lines' colours. 1200 pixels wide. `title` is one line. Throws std::invalid_argument when the images differ in size.
 * \ingroup HeatViews */
HeatViews_EXPORT Picture::Pointer
                      DrawTransferFunction(const Image<float, 3> *       grey,
                                           const Image<float, 3> *       heat,
                                           const ShapeTransferFunction & transferFunction,
                                           const std::string &           title,
                                           const IntensityWindow &       window = {},
                                           const ShapeQuantity &         quantity = {});

/** The number of voxels in each line.
 * \ingroup HeatViews */
HeatViews_EXPORT std::vector<std::uint64_t>
                      CountVoxelsOfLines(const Image<float, 3> * heat, const ShapeTransferFunction & transferFunction);
} // namespace itk

#endif
