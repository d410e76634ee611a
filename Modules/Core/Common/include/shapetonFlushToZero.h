#ifndef shapetonFlushToZero_h
#define shapetonFlushToZero_h

#if defined(__x86_64__)
#  include <xmmintrin.h>
#endif

namespace shapeton
{
/** Flushes subnormal results to 0 in this thread during its lifetime. Otherwise residual heat near 0 slows down every
 * step by a factor of ten. \ingroup ShapetonCommon */
class FlushToZero
{
public:
  FlushToZero(const FlushToZero &) = delete;
  FlushToZero &
  operator=(const FlushToZero &) = delete;

#if defined(__x86_64__)
  FlushToZero() : m_Saved(_mm_getcsr())
  {
    _mm_setcsr(m_Saved | 0x8040U); // flush to zero, denormals are zero
  }
  ~FlushToZero() { _mm_setcsr(m_Saved); }

private:
  unsigned int m_Saved;
#else
  FlushToZero() {}
  ~FlushToZero() {}
#endif
};
} // namespace shapeton

#endif
