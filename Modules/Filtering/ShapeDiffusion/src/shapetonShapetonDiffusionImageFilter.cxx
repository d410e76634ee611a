#include "shapetonShapetonDiffusionImageFilter.h"

namespace shapeton
{
template class ShapetonDiffusionImageFilter<itk::Image<float, 3>>;
template class ShapetonDiffusionImageFilter<itk::Image<short, 3>>;
template class ShapetonDiffusionImageFilter<itk::Image<unsigned char, 3>>;
} // namespace shapeton
