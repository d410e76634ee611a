#define SHAPETON_LANES 8
#define SHAPETON_TILE_VECTORS 3
#define SHAPETON_TILE_COLUMNS 8
#define SHAPETON_NAME "AVX-512"
#include "shapetonPanelKernelsBody.h"

const shapeton::PanelKernels::Set &
shapeton::PanelKernels::GetAvx512()
{
  return kernels;
}
