#ifndef shapetonAlignedBuffer_h
#define shapetonAlignedBuffer_h

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

namespace shapeton
{
/** An uninitialized array of doubles, aligned to a cache line. */
class AlignedBuffer
{
public:
  AlignedBuffer() = default;
  explicit AlignedBuffer(std::size_t size)
    : m_Data(static_cast<double *>(std::aligned_alloc(64, (size * sizeof(double) + 63) / 64 * 64)))
  {
    if (size > 0 && !m_Data)
    {
      throw std::bad_alloc();
    }
  }
  double *
  Data() const
  {
    return m_Data.get();
  }
  void
  Free()
  {
    m_Data.reset();
  }
  explicit operator bool() const { return m_Data != nullptr; }

private:
  struct Deleter
  {
    void
    operator()(double * data) const
    {
      std::free(data);
    }
  };
  std::unique_ptr<double, Deleter> m_Data;
};
} // namespace shapeton

#endif
