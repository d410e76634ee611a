#define SHAPETON_LANES 2
#define SHAPETON_TILE_VECTORS 2
#define SHAPETON_TILE_COLUMNS 4
#define SHAPETON_NAME "baseline"
#include "shapetonPanelKernelsBody.h"

const shapeton::PanelKernels::Set &
shapeton::PanelKernels::GetBaseline()
{
  return kernels;
}
