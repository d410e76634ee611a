#define SHAPETON_LANES 2
#define SHAPETON_TILE_VECTORS 2
#define SHAPETON_TILE_COLUMNS 2
#define SHAPETON_NAME "baseline"
#include "itkFrontKernelsBody.h"

const itk::FrontKernels::Set &
itk::FrontKernels::GetBaseline()
{
  return kernels;
}
