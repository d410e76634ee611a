#define SHAPETON_LANES 4
#define SHAPETON_NAME "baseline"
#include "itkShapetonKernelsBody.h"

const itk::ShapetonKernels::Set &
itk::ShapetonKernels::GetBaseline()
{
  return kernels;
}
