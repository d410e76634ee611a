#include "shapetonCumulativeHeatDiffusionImageFilter.h"

#include "itkVectorImage.h"

// Must not compile: the pixels have several components.
template class shapeton::CumulativeHeatDiffusionImageFilter<itk::VectorImage<float, 3>>;
