#ifndef shapetonDeviceRuntime_h
#define shapetonDeviceRuntime_h

#include "shapetonDevice.h"
#include "shapetonFlushToZero.h"
#include "shapetonHostDevice.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <type_traits>
#include <vector>

/** Prefix of a plug-in function that FindDeviceFunction() can find. */
#define SHAPETON_DEVICE_FUNCTION extern "C" __attribute__((visibility("default")))

namespace shapeton
{
/** Device memory, and launches that call a body for each element, for the kernels in .cu files. The bodies are
 * SHAPETON_HOST_DEVICE functions, which also run on the CPU.
 *
 * nvcc compiles these files for the GPU. Any C++ compiler accepts them as well: a launch is then a loop, and device
 * memory is host memory. This emulation is slow; tests compare its results byte by byte with the CPU code, which covers
 * everything except the hardware.
 *
 * Launches are asynchronous and ordered; copies wait for them.
 *
 * \ingroup ShapetonCommon */
namespace DeviceRuntime
{
/** Voxels along x, y, z. */
struct Extent
{
  std::size_t x;
  std::size_t y;
  std::size_t z;
};

#if defined(__CUDACC__)
inline void
Check(cudaError_t status, const char * action)
{
  if (status != cudaSuccess)
  {
    throw DeviceFailure(std::string("the GPU failed to ") + action + ": " + cudaGetErrorString(status));
  }
}

inline void *
Allocate(std::size_t bytes)
{
  void * memory = nullptr;
  Check(cudaMalloc(&memory, bytes), "allocate memory");
  return memory;
}

inline void
Free(void * memory)
{
  cudaFree(memory);
}

/** Pins host memory for DMA transfers, which are then twice as fast. Small blocks, device memory, and memory that
 * cannot be pinned are left unchanged. */
class PinnedPages
{
public:
  PinnedPages(const void * memory, std::size_t bytes)
  {
    cudaPointerAttributes attributes{};
    if (bytes < WorthPinning || cudaPointerGetAttributes(&attributes, memory) != cudaSuccess ||
        attributes.type != cudaMemoryTypeUnregistered)
    {
      return;
    }
    void * const pages = const_cast<void *>(memory); // pinning does not write
    if (cudaHostRegister(pages, bytes, cudaHostRegisterDefault) == cudaSuccess)
    {
      m_Pages = pages;
    }
    else
    {
      cudaGetLastError(); // clear the error
    }
  }
  PinnedPages(const PinnedPages &) = delete;
  PinnedPages &
  operator=(const PinnedPages &) = delete;
  ~PinnedPages()
  {
    if (m_Pages)
    {
      cudaHostUnregister(m_Pages);
    }
  }

private:
  static constexpr std::size_t WorthPinning = std::size_t{ 4 } << 20; // bytes; smaller copies are not pinned; chosen

  void * m_Pages{ nullptr };
};

/** Copies between host and device or on the device, in any direction. */
inline void
CopyBytes(void * to, const void * from, std::size_t bytes)
{
  const PinnedPages source(from, bytes);
  const PinnedPages target(to, bytes);
  Check(cudaMemcpy(to, from, bytes, cudaMemcpyDefault), "copy memory");
}

inline void
ClearBytes(void * memory, std::size_t bytes)
{
  Check(cudaMemset(memory, 0, bytes), "clear memory");
}

/** Waits until all launches have finished. */
inline void
Synchronize()
{
  Check(cudaDeviceSynchronize(), "finish its work");
}
#else
inline void *
Allocate(std::size_t bytes)
{
  void * const memory = std::malloc(bytes);
  if (!memory)
  {
    throw DeviceFailure("the GPU failed to allocate memory");
  }
  std::memset(memory, 0x7f, bytes); // makes reads of uninitialized memory visible
  return memory;
}

inline void
Free(void * memory)
{
  std::free(memory);
}

inline void
CopyBytes(void * to, const void * from, std::size_t bytes)
{
  std::memcpy(to, from, bytes);
}

inline void
ClearBytes(void * memory, std::size_t bytes)
{
  std::memset(memory, 0, bytes);
}

inline void
Synchronize()
{}
#endif

/** Device memory for a number of elements, initially uninitialized. */
template <typename T>
class Memory
{
public:
  static_assert(std::is_trivially_copyable_v<T>, "the device copies bytes");

  Memory() = default;
  explicit Memory(std::size_t number) : m_Number(number), m_Data(static_cast<T *>(Allocate(number * sizeof(T)))) {}
  Memory(Memory && other) noexcept { this->Swap(other); }
  Memory &
  operator=(Memory && other) noexcept
  {
    this->Swap(other);
    return *this;
  }
  ~Memory() { Free(m_Data); }

  /** Null if empty. */
  T *
  Get() const
  {
    return m_Data;
  }
  std::size_t
  GetNumber() const
  {
    return m_Number;
  }
  void
  Upload(const T * values)
  {
    CopyBytes(m_Data, values, m_Number * sizeof(T));
  }
  void
  Download(T * values) const
  {
    CopyBytes(values, m_Data, m_Number * sizeof(T));
  }
  void
  Clear()
  {
    ClearBytes(m_Data, m_Number * sizeof(T));
  }
  void
  Swap(Memory & other) noexcept
  {
    std::swap(m_Number, other.m_Number);
    std::swap(m_Data, other.m_Data);
  }

private:
  std::size_t m_Number{ 0 };
  T *         m_Data{ nullptr };
};

/** Returns a copy in device memory. */
template <typename T>
Memory<T>
Uploaded(const T * values, std::size_t number)
{
  Memory<T> memory(number);
  memory.Upload(values);
  return memory;
}

#if defined(__CUDACC__)
constexpr unsigned int ThreadsInBlock = 256;     // a power of two, for the reduction; chosen
constexpr unsigned int BlocksOfReduction = 2048; ///< more than any GPU runs concurrently

template <typename TBody>
__global__ void
ForEachKernel(std::size_t number, TBody body)
{
  const std::size_t i = static_cast<std::size_t>(blockIdx.x) * ThreadsInBlock + threadIdx.x;
  if (i < number)
  {
    body(i);
  }
}

/** A thread block is a tile of 32 x 8 voxels; neighbors along y share the cache. */
template <typename TBody>
__global__ void
ForVoxelsKernel(Extent extent, TBody body)
{
  const std::size_t x = static_cast<std::size_t>(blockIdx.x) * 32 + threadIdx.x;
  const std::size_t y = static_cast<std::size_t>(blockIdx.y) * 8 + threadIdx.y;
  if (x < extent.x && y < extent.y)
  {
    body(x, y, static_cast<std::size_t>(blockIdx.z));
  }
}

// Size of a block of ForVoxelsTwice(): its threads cover a tile with a border of one voxel and process this many
// slices.
constexpr int TwiceX = 32;
constexpr int TwiceY = 8;
constexpr int TwiceZ = 64;
#  if defined(__CUDA_ARCH__) && __CUDA_ARCH__ == 750
constexpr int TwiceBlocks = 4; // blocks that fit on a multiprocessor
#  else
constexpr int TwiceBlocks = 6;
#  endif

/** The threads of a tile advance slice by slice. Each computes the first values of its column and keeps three of them;
 * values of neighbors in a slice are in shared memory. The border computes first values only. Three slices of shared
 * memory rotate, so one barrier per slice is enough. */
template <typename TBody>
__global__ void
__launch_bounds__(TwiceX * TwiceY, TwiceBlocks) ForVoxelsTwiceKernel(Extent extent, TBody body)
{
  __shared__ float shared[3][TwiceY][TwiceX];
  const int        tx = static_cast<int>(threadIdx.x);
  const int        ty = static_cast<int>(threadIdx.y);
  const int        x = static_cast<int>(blockIdx.x) * (TwiceX - 2) + tx - 1;
  const int        y = static_cast<int>(blockIdx.y) * (TwiceY - 2) + ty - 1;
  const int        slices = static_cast<int>(extent.z);
  const int        first = static_cast<int>(blockIdx.z) * TwiceZ;
  const int        end = first + TwiceZ < slices ? first + TwiceZ : slices;
  const bool       isInside = x >= 0 && x < static_cast<int>(extent.x) && y >= 0 && y < static_cast<int>(extent.y);
  const bool       isOwn = isInside && tx > 0 && tx < TwiceX - 1 && ty > 0 && ty < TwiceY - 1;
  float            below = 0.0F;
  float            center = 0.0F;
  float            kept = 0.0F;
  int              now = 0;
  int              last = 2;
  for (int z = first - 1; z <= end; ++z)
  {
    float above = 0.0F;
    float keptAbove = 0.0F;
    if (isInside && z >= 0 && z < slices)
    {
      above = body.First(x, y, z, keptAbove);
    }
    shared[now][ty][tx] = above;
    __syncthreads();
    if (isOwn && z > first)
    {
      body.Second(x,
                  y,
                  z - 1,
                  { center,
                    shared[last][ty][tx - 1],
                    shared[last][ty][tx + 1],
                    shared[last][ty - 1][tx],
                    shared[last][ty + 1][tx],
                    below,
                    above },
                  kept);
    }
    below = center;
    center = above;
    kept = keptAbove;
    last = now;
    now = now == 2 ? 0 : now + 1;
  }
}

template <typename TSum, typename TBody>
__global__ void
ReduceKernel(std::size_t number, TBody body, TSum * partial)
{
  __shared__ alignas(TSum) unsigned char memory[ThreadsInBlock * sizeof(TSum)]; // sums are created without a
                                                                                // constructor
  TSum * const sums = reinterpret_cast<TSum *>(memory);
  TSum         sum;
  for (std::size_t i = static_cast<std::size_t>(blockIdx.x) * ThreadsInBlock + threadIdx.x; i < number;
       i += static_cast<std::size_t>(gridDim.x) * ThreadsInBlock)
  {
    body(i, sum);
  }
  sums[threadIdx.x] = sum;
  for (unsigned int half = ThreadsInBlock / 2; half > 0; half /= 2)
  {
    __syncthreads();
    if (threadIdx.x < half)
    {
      sums[threadIdx.x].Add(sums[threadIdx.x + half]);
    }
  }
  if (threadIdx.x == 0)
  {
    partial[blockIdx.x] = sums[0];
  }
}

/** Each thread block counts in its shared memory. */
template <unsigned int VBins, unsigned int VRows, typename TBody>
__global__ void
CountKernel(std::size_t number, TBody body, std::uint32_t * counts)
{
  __shared__ std::uint32_t own[VBins * VRows];
  for (unsigned int bin = threadIdx.x; bin < VBins * VRows; bin += ThreadsInBlock)
  {
    own[bin] = 0;
  }
  __syncthreads();
  for (std::size_t i = static_cast<std::size_t>(blockIdx.x) * ThreadsInBlock + threadIdx.x; i < number;
       i += static_cast<std::size_t>(gridDim.x) * ThreadsInBlock)
  {
    for (unsigned int row = 0; row < VRows; ++row)
    {
      atomicAdd(own + row * VBins + body(i, row), 1U);
    }
  }
  __syncthreads();
  for (unsigned int bin = threadIdx.x; bin < VBins * VRows; bin += ThreadsInBlock)
  {
    if (own[bin] != 0)
    {
      atomicAdd(counts + bin, own[bin]);
    }
  }
}

inline unsigned int
BlocksFor(std::size_t number, std::size_t inBlock)
{
  return static_cast<unsigned int>((number + inBlock - 1) / inBlock);
}

inline unsigned int
BlocksOfLoop(std::size_t number)
{
  const unsigned int blocks = BlocksFor(number, ThreadsInBlock);
  return blocks < BlocksOfReduction ? blocks : BlocksOfReduction;
}

/** Calls body(i) for i < number. */
template <typename TBody>
void
ForEach(std::size_t number, const TBody & body)
{
  if (number > 0)
  {
    ForEachKernel<<<BlocksFor(number, ThreadsInBlock), ThreadsInBlock>>>(number, body);
    Check(cudaGetLastError(), "start a kernel");
  }
}

/** Calls body(x, y, z) for all voxels. */
template <typename TBody>
void
ForVoxels(const Extent & extent, const TBody & body)
{
  const dim3 blocks(BlocksFor(extent.x, 32), BlocksFor(extent.y, 8), static_cast<unsigned int>(extent.z));
  ForVoxelsKernel<<<blocks, dim3(32, 8)>>>(extent, body);
  Check(cudaGetLastError(), "start a kernel");
}

/** Performs two steps of a stencil computation at once, without writing the values of the first step to memory.
 * body.First(x, y, z, kept) returns the value of the first step and stores a number in `kept`. Then body.Second(x,
 * y, z, neighborhood, kept) receives the first-step values of the voxel and its six neighbors, 0 outside the
 * volume, in the order of TBody::Neighborhood, and that number. First() may be called several times per voxel at any
 * time, so neither function may write data that First() reads. */
template <typename TBody>
void
ForVoxelsTwice(const Extent & extent, const TBody & body)
{
  const dim3 blocks(BlocksFor(extent.x, TwiceX - 2), BlocksFor(extent.y, TwiceY - 2), BlocksFor(extent.z, TwiceZ));
  ForVoxelsTwiceKernel<<<blocks, dim3(TwiceX, TwiceY)>>>(extent, body);
  Check(cudaGetLastError(), "start a kernel");
}

/** Returns the sum accumulated by body(i, sum) for i < number, in any order. TSum consists of integers or extrema, is
 * initially 0 and has Add(). */
template <typename TSum, typename TBody>
TSum
Reduce(std::size_t number, const TBody & body)
{
  TSum whole;
  if (number == 0)
  {
    return whole;
  }
  const unsigned int        blocks = BlocksOfLoop(number);
  static const Memory<TSum> partial(BlocksOfReduction); // allocation is slower than most sums
  ReduceKernel<<<blocks, ThreadsInBlock>>>(number, body, partial.Get());
  Check(cudaGetLastError(), "start a kernel");
  std::vector<TSum> sums(blocks);
  CopyBytes(sums.data(), partial.Get(), blocks * sizeof(TSum));
  for (const TSum & sum : sums)
  {
    whole.Add(sum);
  }
  return whole;
}

/** Adds 1 to counts[row * VBins + body(i, row)] for i < number and row < VRows. */
template <unsigned int VBins, unsigned int VRows, typename TBody>
void
Count(std::size_t number, const TBody & body, std::uint32_t * counts)
{
  CountKernel<VBins, VRows><<<BlocksOfLoop(number), ThreadsInBlock>>>(number, body, counts);
  Check(cudaGetLastError(), "start a kernel");
}
#else
/** Flushes subnormal numbers to zero in the emulated loops, as kernels do on the GPU. */
#  if defined(SHAPETON_FLUSH_TO_ZERO)
using LoopMode = FlushToZero;
#  else
struct LoopMode
{
  LoopMode() {}
};
#  endif

template <typename TBody>
void
ForEach(std::size_t number, const TBody & body)
{
  const LoopMode mode;
  for (std::size_t i = 0; i < number; ++i)
  {
    body(i);
  }
}

template <typename TBody>
void
ForVoxels(const Extent & extent, const TBody & body)
{
  const LoopMode mode;
  for (std::size_t z = 0; z < extent.z; ++z)
  {
    for (std::size_t y = 0; y < extent.y; ++y)
    {
      for (std::size_t x = 0; x < extent.x; ++x)
      {
        body(x, y, z);
      }
    }
  }
}

template <typename TBody>
void
ForVoxelsTwice(const Extent & extent, const TBody & body)
{
  const std::size_t  slice = extent.x * extent.y;
  std::vector<float> values(slice * extent.z);
  std::vector<float> kept(values.size());
  ForVoxels(extent, [&](std::size_t x, std::size_t y, std::size_t z) {
    const std::size_t i = z * slice + y * extent.x + x;
    values[i] = body.First(x, y, z, kept[i]);
  });
  ForVoxels(extent, [&](std::size_t x, std::size_t y, std::size_t z) {
    const std::size_t i = z * slice + y * extent.x + x;
    const auto        value = [&](bool isInside, std::size_t at) { return isInside ? values[at] : 0.0F; };
    body.Second(x,
                y,
                z,
                { values[i],
                  value(x > 0, i - 1),
                  value(x + 1 < extent.x, i + 1),
                  value(y > 0, i - extent.x),
                  value(y + 1 < extent.y, i + extent.x),
                  value(z > 0, i - slice),
                  value(z + 1 < extent.z, i + slice) },
                kept[i]);
  });
}

template <typename TSum, typename TBody>
TSum
Reduce(std::size_t number, const TBody & body)
{
  const LoopMode mode;
  TSum           sum;
  for (std::size_t i = 0; i < number; ++i)
  {
    body(i, sum);
  }
  return sum;
}

template <unsigned int VBins, unsigned int VRows, typename TBody>
void
Count(std::size_t number, const TBody & body, std::uint32_t * counts)
{
  const LoopMode mode;
  for (std::size_t i = 0; i < number; ++i)
  {
    for (unsigned int row = 0; row < VRows; ++row)
    {
      ++counts[row * VBins + body(i, row)];
    }
  }
}
#endif

/** Adds 1 to a counter shared by several threads; returns its previous value. */
SHAPETON_HOST_DEVICE std::uint32_t
                     CountOne(std::uint32_t * count)
{
#if defined(__CUDA_ARCH__)
  return atomicAdd(count, 1U);
#else
  return (*count)++;
#endif
}
} // namespace DeviceRuntime
} // namespace shapeton

#endif
