#include "itkShapetonDiffusionImageFilter.h"

namespace itk
{
template class ShapetonDiffusionImageFilter<Image<float, 3>>;
template class ShapetonDiffusionImageFilter<Image<short, 3>>;
template class ShapetonDiffusionImageFilter<Image<unsigned char, 3>>;
} // namespace itk
