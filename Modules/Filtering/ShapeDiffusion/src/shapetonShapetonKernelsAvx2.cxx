#define SHAPETON_LANES 8
#define SHAPETON_NAME "AVX2"
#include "shapetonShapetonKernelsBody.h"

const shapeton::ShapetonKernels::Set &
shapeton::ShapetonKernels::GetAvx2()
{
  return kernels;
}
