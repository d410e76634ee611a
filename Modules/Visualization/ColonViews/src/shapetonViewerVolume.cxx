#include "shapetonViewerVolume.h"

#include "itkImageRegionConstIterator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace shapeton
{
namespace
{
using VolumeType = itk::Image<float, 3>;
using MaskType = itk::Image<unsigned char, 3>;

constexpr double marginOfVolume = 15.0;
constexpr int    side = 4; // of the blocks that are averaged

/** HU from the lowest to the highest code of 8 bits. */
constexpr double rangeOfByte = 1536.0;

/** Encoding of a value. 8 bits: steps of 6 HU, below the noise of CT colonography. */
struct Quantization
{
  double lowest{ -1024.0 };
  double step{ rangeOfByte / 255.0 };
  double greatest{ 255.0 };

  double
  operator()(double value) const
  {
    return std::clamp(std::round((value - lowest) / step), 0.0, greatest);
  }
};

Quantization
QuantizationOf(bool isCt, int bits)
{
  if (!isCt)
  {
    return { 0.0, 1.0, 255.0 };
  }
  return bits == 8 ? Quantization{}
                   : Quantization{ std::numeric_limits<std::int16_t>::lowest(),
                                   1.0,
                                   std::numeric_limits<std::uint16_t>::max() };
}

VolumeType::RegionType
BoxOf(const VolumeType & volume, const VertexMatrix & points)
{
  const auto            whole = volume.GetLargestPossibleRegion();
  std::array<double, 3> least{ INFINITY, INFINITY, INFINITY };
  std::array<double, 3> most{ -INFINITY, -INFINITY, -INFINITY };
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const auto index =
      volume.TransformPhysicalPointToContinuousIndex<double>(itk::Point<double, 3>(points.row(i).eval().data()));
    for (int k = 0; k < 3; ++k)
    {
      least[k] = std::min(least[k], index[k]);
      most[k] = std::max(most[k], index[k]);
    }
  }
  VolumeType::RegionType box;
  for (int k = 0; k < 3; ++k)
  {
    const double reach = marginOfVolume / volume.GetSpacing()[k];
    const auto   last = static_cast<double>(whole.GetSize(k)) - 1.0;
    const auto   from = static_cast<itk::IndexValueType>(std::clamp(std::floor(least[k] - reach), 0.0, last));
    const auto   to = static_cast<itk::IndexValueType>(std::clamp(std::ceil(most[k] + reach), 0.0, last));
    box.SetIndex(k, from);
    box.SetSize(k, to - from + 1);
  }
  return box;
}

/** A box cut into blocks of `side`^3 voxels; those at the far borders may be smaller. */
class BlockGrid
{
public:
  explicit BlockGrid(const VolumeType::SizeType & size) : m_Size(size)
  {
    for (int k = 0; k < 3; ++k)
    {
      m_Blocks[k] = (size[k] + side - 1) / side;
    }
  }

  std::size_t
  Count() const
  {
    return m_Blocks[0] * m_Blocks[1] * m_Blocks[2];
  }
  const std::array<std::size_t, 3> &
  Blocks() const
  {
    return m_Blocks;
  }
  /** Block of the voxel with this index in the box. */
  std::size_t
  BlockOf(std::size_t voxel) const
  {
    const std::size_t x = voxel % m_Size[0] / side;
    const std::size_t y = voxel / m_Size[0] % m_Size[1] / side;
    const std::size_t z = voxel / (m_Size[0] * m_Size[1]) / side;
    return x + m_Blocks[0] * (y + m_Blocks[1] * z);
  }
  std::array<std::size_t, 3>
  PlaceOf(std::size_t block) const
  {
    return { block % m_Blocks[0], block / m_Blocks[0] % m_Blocks[1], block / (m_Blocks[0] * m_Blocks[1]) };
  }

private:
  VolumeType::SizeType       m_Size;
  std::array<std::size_t, 3> m_Blocks{};
};

/** Marks all blocks within `reach` blocks along one axis of a marked one. */
std::vector<char>
Widened(const std::vector<char> & marked, const BlockGrid & grid, int axis, int reach)
{
  std::size_t stride = 1;
  for (int k = 0; k < axis; ++k)
  {
    stride *= grid.Blocks()[k];
  }
  std::vector<char> wide(marked.size(), 0);
  for (std::size_t block = 0; block < marked.size(); ++block)
  {
    const auto place = static_cast<int>(grid.PlaceOf(block)[axis]);
    const int  from = std::max(-reach, -place);
    const int  to = std::min(reach, static_cast<int>(grid.Blocks()[axis]) - 1 - place);
    for (int shift = from; shift <= to && wide[block] == 0; ++shift)
    {
      wide[block] = marked[block + shift * static_cast<std::ptrdiff_t>(stride)];
    }
  }
  return wide;
}

/** 1 for blocks without a lumen voxel within `near` mm. Conservative: uses boxes around the lumen. */
std::vector<std::uint8_t>
FarBlocks(const MaskType & lumen, const VolumeType::RegionType & box, const BlockGrid & grid, double near)
{
  std::vector<char>                       marked(grid.Count(), 0);
  itk::ImageRegionConstIterator<MaskType> voxels(&lumen, box);
  for (std::size_t voxel = 0; !voxels.IsAtEnd(); ++voxels, ++voxel)
  {
    if (voxels.Get() != 0)
    {
      marked[grid.BlockOf(voxel)] = 1;
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    marked = Widened(marked, grid, axis, static_cast<int>(std::ceil(near / (side * lumen.GetSpacing()[axis]))));
  }
  std::vector<std::uint8_t> far(marked.size());
  std::transform(marked.begin(), marked.end(), far.begin(), [](char isNear) { return isNear != 0 ? 0 : 1; });
  return far;
}

std::vector<float>
ValuesIn(const VolumeType & volume, const VolumeType::RegionType & box)
{
  std::vector<float> values;
  values.reserve(box.GetNumberOfPixels());
  for (itk::ImageRegionConstIterator<VolumeType> voxels(&volume, box); !voxels.IsAtEnd(); ++voxels)
  {
    values.push_back(voxels.Get());
  }
  return values;
}

void
TakeMeans(std::vector<float> & values, const BlockGrid & grid, const std::vector<std::uint8_t> & far)
{
  std::vector<double> sums(far.size(), 0.0);
  std::vector<int>    counts(far.size(), 0);
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel)
  {
    const std::size_t block = grid.BlockOf(voxel);
    sums[block] += values[voxel];
    ++counts[block];
  }
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel)
  {
    const std::size_t block = grid.BlockOf(voxel);
    if (far[block] != 0)
    {
      values[voxel] = static_cast<float>(sums[block] / counts[block]);
    }
  }
}

Json
HeaderOf(const VolumeType & volume, const VolumeType::RegionType & box, const Quantization & quantize)
{
  VolumeType::PointType origin;
  volume.TransformIndexToPhysicalPoint(box.GetIndex(), origin);
  Json header{ { "size", Json::array() }, { "origin", Json::array() }, { "spacing", Json::array() } };
  header["axes"] = Json::array();
  for (int k = 0; k < 3; ++k)
  {
    header["size"].push_back(box.GetSize(k));
    header["origin"].push_back(origin[k]);
    header["spacing"].push_back(volume.GetSpacing()[k]);
    const auto & direction = volume.GetDirection();
    header["axes"].push_back({ direction(0, k), direction(1, k), direction(2, k) });
  }
  header["hu"] = { quantize.lowest, quantize.step };
  header["side"] = side;
  return header;
}

template <typename TStored>
void
PutValues(PageBlocks &               blocks,
          const std::string &        name,
          const std::vector<float> & values,
          const Quantization &       quantize,
          const Json &               header)
{
  std::vector<TStored> stored(values.size());
  std::transform(
    values.begin(), values.end(), stored.begin(), [&](float value) { return static_cast<TStored>(quantize(value)); });
  blocks.Put(name, stored, 1, header);
}
} // namespace

void
PutViewerVolume(PageBlocks &               blocks,
                const std::string &        name,
                const VolumeType &         volume,
                const MaskType &           lumen,
                const VertexMatrix &       points,
                bool                       isCt,
                const ColonViewerOptions & options)
{
  const auto         box = BoxOf(volume, points);
  const BlockGrid    grid(box.GetSize());
  const auto         far = FarBlocks(lumen, box, grid, options.near);
  std::vector<float> values = ValuesIn(volume, box);
  TakeMeans(values, grid, far);
  blocks.Put(name + "Coarse", far);
  const Quantization quantize = QuantizationOf(isCt, options.bits);
  Json               header = HeaderOf(volume, box, quantize);
  header["isCt"] = isCt;
  if (options.bits == 8)
  {
    PutValues<std::uint8_t>(blocks, name, values, quantize, header);
  }
  else
  {
    PutValues<std::uint16_t>(blocks, name, values, quantize, header);
  }
}
} // namespace shapeton
