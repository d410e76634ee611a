#ifndef shapetonVoxelValues_h
#define shapetonVoxelValues_h

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace shapeton
{
/** \class UninitializedAllocator
 * \brief Allocator that default-initializes elements, so that the threads that fill a volume touch its memory first.
 * This avoids zeroing hundreds of megabytes in one thread.
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

/** Values of the voxels of a grid; those of VoxelValues(n) must be set before they are read. \ingroup ShapetonCommon */
using VoxelValues = std::vector<float, UninitializedAllocator<float>>;
} // namespace shapeton

#endif
