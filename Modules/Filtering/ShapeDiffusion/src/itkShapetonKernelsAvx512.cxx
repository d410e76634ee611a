#define SHAPETON_LANES 16
#define SHAPETON_NAME "AVX-512"
#include "itkShapetonKernelsBody.h"

const itk::ShapetonKernels::Set &
itk::ShapetonKernels::GetAvx512()
{
  return kernels;
}
