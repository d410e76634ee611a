#include "shapetonCumulativeHeatDiffusionImageFilter.h"

namespace shapeton
{
template class CumulativeHeatDiffusionImageFilter<itk::Image<float, 3>>;
template class CumulativeHeatDiffusionImageFilter<itk::Image<short, 3>>;
template class CumulativeHeatDiffusionImageFilter<itk::Image<unsigned char, 3>>;
} // namespace shapeton
