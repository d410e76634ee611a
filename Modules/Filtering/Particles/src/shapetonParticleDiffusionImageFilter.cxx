#include "shapetonParticleDiffusionImageFilter.h"

namespace shapeton
{
template class ParticleDiffusionImageFilter<itk::Image<float, 3>>;
template class ParticleDiffusionImageFilter<itk::Image<short, 3>>;
template class ParticleDiffusionImageFilter<itk::Image<unsigned char, 3>>;
} // namespace shapeton
