#define SHAPETON_LANES 4
#define SHAPETON_TILE_VECTORS 3
#define SHAPETON_TILE_COLUMNS 4
#define SHAPETON_NAME "AVX2"
#include "itkPanelKernelsBody.h"

const itk::PanelKernels::Set &
itk::PanelKernels::GetAvx2()
{
  return kernels;
}
