#include "shapetonDiffusionKernels.h"

#if defined(__x86_64__)
#  include <xmmintrin.h>
#endif

namespace shapeton
{
namespace DiffusionKernels
{
FlushToZero::FlushToZero()
#if defined(__x86_64__)
  : m_Saved(_mm_getcsr())
{
  _mm_setcsr(m_Saved | 0x8040U); // flush to zero, denormals are zero
}

FlushToZero::~FlushToZero() { _mm_setcsr(m_Saved); }
#else
  : m_Saved(0)
{}
FlushToZero::~FlushToZero() = default;
#endif
} // namespace DiffusionKernels
} // namespace shapeton
