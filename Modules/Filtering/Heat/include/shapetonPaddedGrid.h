#ifndef shapetonPaddedGrid_h
#define shapetonPaddedGrid_h

#include "ShapetonHeatExport.h"

#include <array>
#include <cstddef>
#include <memory>

namespace shapeton
{
/** \class PaddedGrid
 * \brief Memory layout of a field on an nx x ny x nz volume with a border of one voxel.
 *
 * Rows along x are padded to full cache lines; the border avoids boundary checks in the diffusion.
 *
 * \ingroup ShapetonHeat */
class PaddedGrid
{
public:
  PaddedGrid() = default;
  explicit PaddedGrid(const std::array<std::size_t, 3> & size)
    : m_Size(size)
    , m_RowStride((size[0] + 1 + Alignment - 1) / Alignment * Alignment)
    , m_SliceStride(m_RowStride * (size[1] + 2))
    , m_Length(m_SliceStride * (size[2] + 2) + 2 * Alignment)
  {}

  const std::array<std::size_t, 3> &
  GetSize() const
  {
    return m_Size;
  }
  std::size_t
  GetNumberOfVoxels() const
  {
    return m_Size[0] * m_Size[1] * m_Size[2];
  }
  /** Distance in memory between neighbors along an axis. */
  std::size_t
  GetStride(unsigned int axis) const
  {
    return axis == 0 ? 1 : axis == 1 ? m_RowStride : m_SliceStride;
  }
  /** Number of floats of a field. */
  std::size_t
  GetLength() const
  {
    return m_Length;
  }
  /** Offset of the first voxel of a row; y may be from -1 to ny, and z from -1 to nz. */
  std::size_t
  GetRow(std::ptrdiff_t y, std::ptrdiff_t z) const
  {
    return static_cast<std::size_t>(z + 1) * m_SliceStride + static_cast<std::size_t>(y + 1) * m_RowStride + Alignment;
  }

private:
  static constexpr std::size_t Alignment = 16; // floats in a cache line

  std::array<std::size_t, 3> m_Size{};
  std::size_t                m_RowStride{ 0 };
  std::size_t                m_SliceStride{ 0 };
  std::size_t                m_Length{ 0 };
};

/** \class PaddedField
 * \brief Values of a field on a PaddedGrid, initially 0.
 * \ingroup ShapetonHeat */
class ShapetonHeat_EXPORT PaddedField
{
public:
  PaddedField() = default;
  enum class Memory
  {
    Whole,   ///< in large pages, for speed
    OnDemand ///< where it is written first
  };
  explicit PaddedField(const PaddedGrid & grid, Memory memory = Memory::Whole);

  float *
  GetData()
  {
    return m_Data.get();
  }
  const float *
  GetData() const
  {
    return m_Data.get();
  }

private:
  struct Free
  {
    void
    operator()(float * data) const;
  };
  std::unique_ptr<float[], Free> m_Data;
};
} // namespace shapeton

#endif
