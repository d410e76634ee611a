#ifndef shapetonClassifiedVolume_h
#define shapetonClassifiedVolume_h

#include "shapetonRayArithmetic.h"
#include "shapetonShapeTransferFunction.h"

#include "itkImage.h"

#include <array>
#include <cstdint>
#include <vector>

namespace shapeton
{
/** \class ClassifiedVolume
 * \brief A heat volume prepared for ray casting: the transfer function's line of each voxel, and smoothed opacity for
 * normals.
 */
class ClassifiedVolume
{
public:
  ClassifiedVolume(const itk::Image<float, 3> * heat, const ShapeTransferFunction & transferFunction);

  /** Data for the ray caster, owned by this object. */
  RayVolume
  GetRayVolume() const;

  std::size_t
  GetNumberOfSamples() const
  {
    return m_Samples.size();
  }

private:
  static constexpr int BlockSize = RayBlockSize;
  using Content = RayContent;

  void
  Classify(const itk::Image<float, 3> * heat, const ShapeTransferFunction & transferFunction);
  void
  MarkOccupiedBlocks();
  void
  MarkUniformBlocks();
  std::size_t
  BlockIndex(int x, int y, int z) const;
  void
  SmoothOpacity();

  std::array<int, 3>         m_Size{};
  std::array<int, 3>         m_Blocks{};
  std::vector<RaySample>     m_Samples; // for "no line" and for each line
  std::vector<std::uint8_t>  m_Lines;   // 0: none, else the line's index + 1
  std::vector<std::uint16_t> m_SmoothOpacity;
  std::vector<Content>       m_Content; // for each block
};
} // namespace shapeton

#endif
