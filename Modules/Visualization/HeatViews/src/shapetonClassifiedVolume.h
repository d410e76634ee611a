#ifndef shapetonClassifiedVolume_h
#define shapetonClassifiedVolume_h

#include "shapetonShapeTransferFunction.h"

#include "itkImage.h"

#include <array>
#include <cstdint>
#include <vector>

namespace shapeton
{
/** \class ClassifiedVolume
 * \brief A heat volume as a ray caster needs it: the transfer function's line of each voxel, and smooth opacity for
 * normals.
 *
 * Positions are continuous indices relative to the first voxel.
 */
class ClassifiedVolume
{
public:
  /** Colour multiplied by opacity, and opacity, all in [0, 1]. */
  using Sample = std::array<float, 4>;

  ClassifiedVolume(const itk::Image<float, 3> * heat, const ShapeTransferFunction & transferFunction);

  /** What the neighbourhood of a position holds, without looking at its voxels. */
  enum class Content : std::uint8_t
  {
    Transparent,
    Mixed,
    /** One line, so far around that there is no gradient. */
    Uniform
  };
  Content
  ContentAt(const double position[3]) const;

  /** Colour and opacity between voxels. The border of an object, where half of it is interpolated, is made twice as
   * steep, so that the object keeps its size. */
  Sample
  SampleAt(const double position[3]) const;

  /** The same where the content is uniform. */
  Sample
  UniformSampleAt(const double position[3]) const;

  /** The gradient, for each voxel along its axis, of the smoothed opacity. */
  std::array<float, 3>
  GradientAt(const double position[3]) const;

  const std::array<int, 3> &
  GetSize() const
  {
    return m_Size;
  }

private:
  static constexpr int BlockSize = 8;

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
  float
  SmoothOpacityAt(int x, int y, int z) const;

  std::array<int, 3>         m_Size{};
  std::array<int, 3>         m_Blocks{};
  std::vector<Sample>        m_Samples; // of "no line" and of each line
  std::vector<std::uint8_t>  m_Lines;   // 0: none, else the line's index + 1
  std::vector<std::uint16_t> m_SmoothOpacity;
  std::vector<Content>       m_Content; // of each block
};
} // namespace shapeton

#endif
