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

constexpr double marginOfVolume = 15.0; // mm around the colon; chosen
constexpr int    side = 4;              // of the blocks that are averaged

/** Codes of HU: equal steps up to the code `knee`, larger ones above it, so that 8 bits also hold contrast medium. */
struct Quantization
{
  double lowest;
  double step;
  double knee;
  double stepAbove;
  double greatest;

  double
  operator()(double value) const
  {
    const double low = (value - lowest) / step;
    const double code = low <= knee ? low : knee + (low - knee) * step / stepAbove;
    return std::clamp(std::round(code), 0.0, greatest);
  }
};

/** 8 bits: -1024 to 320 HU in steps of 6 HU, below the noise of CT colonography, and up to 1560 HU, tagged residue, in
 * steps of 40 HU. */
constexpr Quantization byteOfCt{ -1024.0, 6.0, 224.0, 40.0, 255.0 };

Quantization
QuantizationOf(bool isCt, int bits)
{
  constexpr double most = std::numeric_limits<std::uint16_t>::max();
  if (!isCt)
  {
    constexpr double labels = 255.0;
    return { 0.0, 1.0, labels, 1.0, labels };
  }
  return bits == 8 ? byteOfCt : Quantization{ std::numeric_limits<std::int16_t>::lowest(), 1.0, most, 1.0, most };
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
HeaderOf(const ViewerVolume & volume, const VolumeType::RegionType & box, const Quantization & quantize)
{
  const VolumeType &    grid = *volume.shown;
  const auto            whole = grid.GetLargestPossibleRegion();
  VolumeType::PointType origin;
  grid.TransformIndexToPhysicalPoint(box.GetIndex(), origin);
  Json header;
  for (int k = 0; k < 3; ++k)
  {
    header["size"].push_back(box.GetSize(k));
    header["first"].push_back(box.GetIndex(k) - whole.GetIndex(k));
    header["whole"].push_back(whole.GetSize(k));
    header["origin"].push_back(origin[k]);
    header["spacing"].push_back(grid.GetSpacing()[k]);
    const auto & direction = grid.GetDirection();
    header["axes"].push_back({ direction(0, k), direction(1, k), direction(2, k) });
  }
  header["hu"] = { quantize.lowest, quantize.step, quantize.knee, quantize.stepAbove };
  header["side"] = side;
  header["isCt"] = volume.isCt;
  header["isCleansed"] = volume.isCleansed;
  header["hasCleansed"] = volume.cleansed != nullptr;
  return header;
}

/** Stores one volume completely, but only those voxels of the cleansed CT that differ. They are few, in the fluid and
 * at its borders.
 */
template <typename TStored>
class VolumeWriter
{
public:
  VolumeWriter(const VolumeType::RegionType & box, const BlockGrid & grid, const std::vector<std::uint8_t> & far)
    : m_Box(box), m_Grid(grid), m_Far(far)
  {}

  void
  Put(PageBlocks & blocks, const std::string & name, const ViewerVolume & volume, const Quantization & quantize) const
  {
    const std::vector<TStored> shown = this->CodesOf(*volume.shown, quantize);
    blocks.Put(name, shown, 1, HeaderOf(volume, m_Box, quantize));
    if (volume.cleansed == nullptr)
    {
      return;
    }
    const std::vector<TStored> cleansed = this->CodesOf(*volume.cleansed, quantize);
    std::vector<std::uint32_t> places;
    std::vector<TStored>       codes;
    for (std::size_t i = 0; i < shown.size(); ++i)
    {
      if (shown[i] != cleansed[i])
      {
        places.push_back(static_cast<std::uint32_t>(i));
        codes.push_back(cleansed[i]);
      }
    }
    blocks.Put(name + "CleansedAt", places, 1);
    blocks.Put(name + "Cleansed", codes, 1);
  }

private:
  std::vector<TStored>
  CodesOf(const VolumeType & volume, const Quantization & quantize) const
  {
    std::vector<float> values = ValuesIn(volume, m_Box);
    TakeMeans(values, m_Grid, m_Far);
    std::vector<TStored> codes(values.size());
    std::transform(
      values.begin(), values.end(), codes.begin(), [&](float value) { return static_cast<TStored>(quantize(value)); });
    return codes;
  }

  const VolumeType::RegionType &    m_Box;
  const BlockGrid &                 m_Grid;
  const std::vector<std::uint8_t> & m_Far;
};
} // namespace

void
PutViewerVolume(PageBlocks &               blocks,
                const std::string &        name,
                const ViewerVolume &       volume,
                const MaskType &           lumen,
                const VertexMatrix &       points,
                const ColonViewerOptions & options)
{
  const auto                      box = BoxOf(*volume.shown, points);
  const BlockGrid                 grid(box.GetSize());
  const std::vector<std::uint8_t> far =
    options.isFull ? std::vector<std::uint8_t>(grid.Count(), 0) : FarBlocks(lumen, box, grid, options.near);
  blocks.Put(name + "Coarse", far);
  const Quantization quantize = QuantizationOf(volume.isCt, options.bits);
  if (options.bits == 8)
  {
    VolumeWriter<std::uint8_t>(box, grid, far).Put(blocks, name, volume, quantize);
  }
  else
  {
    VolumeWriter<std::uint16_t>(box, grid, far).Put(blocks, name, volume, quantize);
  }
}
} // namespace shapeton
