#ifndef shapetonTestThreads_h
#define shapetonTestThreads_h

#include "itkMultiThreaderBase.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace basetest
{
/** Sets ITK's global default number of threads during its lifetime. */
class ThreadNumber
{
public:
  explicit ThreadNumber(unsigned int threads) : m_Before(itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads())
  {
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
  }
  ~ThreadNumber() { itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(m_Before); }

private:
  unsigned int m_Before;
};

/** Expects that the value of `work` with one thread equals those with these numbers of threads. */
template <typename TWork>
void
ExpectSameWithAnyThreads(const TWork & work, const std::initializer_list<unsigned int> & numbers = { 2, 5 })
{
  const auto one = [&] {
    const ThreadNumber single(1);
    return work();
  }();
  for (const unsigned int threads : numbers)
  {
    const ThreadNumber number(threads);
    EXPECT_TRUE(work() == one) << threads << " threads";
  }
}

/** The bytes of the pixels of an image. */
template <typename TImage>
std::string
BytesOf(const TImage * image)
{
  return { reinterpret_cast<const char *>(image->GetBufferPointer()),
           image->GetBufferedRegion().GetNumberOfPixels() * sizeof(typename TImage::PixelType) };
}

template <typename TImage>
std::string
BytesOf(const itk::SmartPointer<TImage> & image)
{
  return BytesOf(image.GetPointer());
}
} // namespace basetest

#endif
