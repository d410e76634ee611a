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
  static constexpr std::size_t Alignment = 64; ///< bytes; a cache line

  AlignedBuffer() = default;
  explicit AlignedBuffer(std::size_t size)
    : m_Data(static_cast<double *>(
        std::aligned_alloc(Alignment, (size * sizeof(double) + Alignment - 1) / Alignment * Alignment)))
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
