#define SHAPETON_LANES 8
#define SHAPETON_TILE_VECTORS 3
#define SHAPETON_TILE_COLUMNS 8
#define SHAPETON_NAME "AVX-512"
#include "itkPanelKernelsBody.h"

const itk::PanelKernels::Set &
itk::PanelKernels::GetAvx512()
{
  return kernels;
}
