#include "itkCumulativeHeatDiffusionImageFilter.h"

namespace itk
{
template class CumulativeHeatDiffusionImageFilter<Image<float, 3>>;
template class CumulativeHeatDiffusionImageFilter<Image<short, 3>>;
template class CumulativeHeatDiffusionImageFilter<Image<unsigned char, 3>>;
} // namespace itk
