#define SHAPETON_LANES 8
#define SHAPETON_NAME "AVX2"
#include "itkShapetonKernelsBody.h"

const itk::ShapetonKernels::Set &
itk::ShapetonKernels::GetAvx2()
{
  return kernels;
}
