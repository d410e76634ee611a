#define SHAPETON_LANES 8
#define SHAPETON_TILE_VECTORS 2
#define SHAPETON_TILE_COLUMNS 4
#define SHAPETON_NAME "AVX-512"
#include "shapetonFrontKernelsBody.h"

const shapeton::FrontKernels::Set &
shapeton::FrontKernels::GetAvx512()
{
  return kernels;
}
