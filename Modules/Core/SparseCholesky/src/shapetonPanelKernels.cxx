#include "shapetonPanelKernels.h"

const shapeton::PanelKernels::Set &
shapeton::PanelKernels::GetBest()
{
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f"))
  {
    return GetAvx512();
  }
  if (__builtin_cpu_supports("avx2"))
  {
    return GetAvx2();
  }
#endif
  return GetBaseline();
}
