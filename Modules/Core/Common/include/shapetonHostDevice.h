#ifndef shapetonHostDevice_h
#define shapetonHostDevice_h

/** Prefix of a function that runs on the CPU and in GPU kernels: both perform the same operations in the same order.
 * Always inlined: kernels are compiled for several instruction sets, and the linker would keep the code of a
 * non-inlined function for only one of them. */
#if defined(__CUDACC__)
#  define SHAPETON_HOST_DEVICE __host__ __device__ __forceinline__
#else
#  define SHAPETON_HOST_DEVICE __attribute__((always_inline)) inline
#endif

/** Prefetches memory on a CPU; a GPU hides the latency with other threads. */
#if defined(__CUDA_ARCH__)
#  define SHAPETON_PREFETCH(...) static_cast<void>(0)
#else
#  define SHAPETON_PREFETCH(...) __builtin_prefetch(__VA_ARGS__)
#endif

namespace shapeton
{
/** Arithmetic for kernels where the standard library is not guaranteed to be exact on a GPU. \ingroup ShapetonCommon */
namespace HostDevice
{
template <typename T>
SHAPETON_HOST_DEVICE T
Smaller(T a, T b)
{
  return b < a ? b : a;
}

template <typename T>
SHAPETON_HOST_DEVICE T
Larger(T a, T b)
{
  return a < b ? b : a;
}

/** Dot product, accumulated from the first component to the last. */
SHAPETON_HOST_DEVICE double
Product(const double a[3], const double b[3])
{
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    sum += a[axis] * b[axis];
  }
  return sum;
}
} // namespace HostDevice
} // namespace shapeton

#endif
