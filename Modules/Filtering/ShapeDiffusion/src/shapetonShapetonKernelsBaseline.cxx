#define SHAPETON_LANES 4
#define SHAPETON_NAME "baseline"
#include "shapetonShapetonKernelsBody.h"

const shapeton::ShapetonKernels::Set &
shapeton::ShapetonKernels::GetBaseline()
{
  return kernels;
}
