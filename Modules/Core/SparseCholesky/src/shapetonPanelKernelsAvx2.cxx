#define SHAPETON_LANES 4
#define SHAPETON_TILE_VECTORS 3
#define SHAPETON_TILE_COLUMNS 4
#define SHAPETON_NAME "AVX2"
#include "shapetonPanelKernelsBody.h"

const shapeton::PanelKernels::Set &
shapeton::PanelKernels::GetAvx2()
{
  return kernels;
}
