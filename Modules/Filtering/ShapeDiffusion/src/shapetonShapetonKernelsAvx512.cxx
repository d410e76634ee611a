#define SHAPETON_LANES 16
#define SHAPETON_NAME "AVX-512"
#include "shapetonShapetonKernelsBody.h"

const shapeton::ShapetonKernels::Set &
shapeton::ShapetonKernels::GetAvx512()
{
  return kernels;
}
