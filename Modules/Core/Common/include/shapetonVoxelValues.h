#ifndef shapetonVoxelValues_h
#define shapetonVoxelValues_h

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace shapeton
{
/** \class UninitializedAllocator
 * \brief Allocator that default-initializes elements. The threads that fill a volume then touch its memory first, and
 * no thread zeroes hundreds of megabytes.
 * \ingroup ShapetonCommon */
template <typename T>
class UninitializedAllocator : public std::allocator<T>
{
public:
  template <typename U>
  struct rebind
  {
    using other = UninitializedAllocator<U>;
  };

  UninitializedAllocator() = default;
  template <typename U>
  explicit UninitializedAllocator(const UninitializedAllocator<U> &)
  {}

  template <typename U>
  void
  construct(U * place)
  {
    ::new (static_cast<void *>(place)) U;
  }

  template <typename U, typename... TArguments>
  void
  construct(U * place, TArguments &&... arguments)
  {
    ::new (static_cast<void *>(place)) U(std::forward<TArguments>(arguments)...);
  }
};

/** Values of the voxels of a grid; VoxelValues(n) is uninitialized. \ingroup ShapetonCommon */
using VoxelValues = std::vector<float, UninitializedAllocator<float>>;
} // namespace shapeton

#endif
