#define SHAPETON_LANES 2
#define SHAPETON_TILE_VECTORS 2
#define SHAPETON_TILE_COLUMNS 2
#define SHAPETON_NAME "baseline"
#include "shapetonFrontKernelsBody.h"

const shapeton::FrontKernels::Set &
shapeton::FrontKernels::GetBaseline()
{
  return kernels;
}
