#define SHAPETON_LANES 4
#define SHAPETON_TILE_VECTORS 2
#define SHAPETON_TILE_COLUMNS 2
#define SHAPETON_NAME "AVX2"
#include "itkFrontKernelsBody.h"

const itk::FrontKernels::Set &
itk::FrontKernels::GetAvx2()
{
  return kernels;
}
