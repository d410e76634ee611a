#define SHAPETON_LANES 2
#define SHAPETON_TILE_VECTORS 2
#define SHAPETON_TILE_COLUMNS 4
#define SHAPETON_NAME "baseline"
#include "itkPanelKernelsBody.h"

const itk::PanelKernels::Set &
itk::PanelKernels::GetBaseline()
{
  return kernels;
}
