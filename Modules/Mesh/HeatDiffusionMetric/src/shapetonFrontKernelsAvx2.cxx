#define SHAPETON_LANES 4
#define SHAPETON_TILE_VECTORS 2
#define SHAPETON_TILE_COLUMNS 2
#define SHAPETON_NAME "AVX2"
#include "shapetonFrontKernelsBody.h"

const shapeton::FrontKernels::Set &
shapeton::FrontKernels::GetAvx2()
{
  return kernels;
}
