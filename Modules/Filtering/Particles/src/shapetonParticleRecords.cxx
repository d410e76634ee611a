#include "shapetonParticleRecords.h"

#include "shapetonChecksum.h"
#include "shapetonHugePages.h"
#include "shapetonParallelFor.h"
#include "shapetonParticleKernels.h"

#include <cmath>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace shapeton
{
namespace
{
using namespace ParticleKernels;

/** Only a weight of 0 becomes 0; any other weight keeps its edge open. */
std::uint16_t
Quantized(float conductance, float perWeight)
{
  return conductance <= 0.0F ? 0 : static_cast<std::uint16_t>(std::max(1.0F, std::round(conductance * perWeight)));
}

std::uint32_t
SumOf(const std::uint16_t * record)
{
  return std::accumulate(record, record + MarksOfRecord, 0U);
}

struct SliceSums
{
  std::uint64_t objectVoxels{ 0 };
  std::uint32_t greatestSum{ 0 };
  std::uint64_t checksum{ 0 };
};

/** The six weights of each voxel of a row, in units of 1 / 65535. \equation{3.1} without its first term, as on a
 * regular grid. */
void
FillRow(const VolumeGradientOperator & volumeGradient, std::size_t y, std::size_t z, std::uint16_t * records)
{
  const PaddedGrid & grid = volumeGradient.GetGrid();
  const std::size_t  row = grid.GetRow(y, z);
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const float * const conductances = volumeGradient.GetConductances(axis) + row;
    const auto          stride = static_cast<std::ptrdiff_t>(grid.GetStride(axis));
    const float         perWeight = static_cast<float>(65535.0 / volumeGradient.GetFactor(axis));
    for (std::ptrdiff_t x = 0; x < static_cast<std::ptrdiff_t>(grid.GetSize()[0]); ++x)
    {
      std::uint16_t * const pair = records + x * RecordLength + 2 * axis;
      pair[0] = Quantized((conductances - stride)[x], perWeight);
      pair[1] = Quantized(conductances[x], perWeight);
    }
  }
}

/** Some slices with one more slice on each side, if present, so that weights equal the weights of the full volume. */
struct RecordSlab
{
  RecordSlab(std::size_t begin, std::size_t number, std::size_t slices)
    : first(begin)
    , end(std::min(begin + number, slices))
    , outerFirst(begin == 0 ? 0 : begin - 1)
    , outerEnd(std::min(end + 1, slices))
  {}

  std::size_t first;
  std::size_t end;
  std::size_t outerFirst;
  std::size_t outerEnd;
};

/** Voxels per slab, limited for a responsive abort. */
constexpr std::size_t SlabVoxels = std::size_t{ 1 } << 20;
} // namespace

ParticleRecords::ParticleRecords(const EdgeVolume &            edges,
                                 const unsigned char *         mask,
                                 const std::function<void()> & poll)
{
  const float * const intensities = edges.volume.values;
  const auto &        size = edges.volume.size;
  const std::size_t   sliceLength = size[0] * size[1];
  const std::size_t   voxels = sliceLength * size[2];
  const double        lower = (*edges.options.intensityWindow)[0];
  const auto isObject = [&](std::size_t voxel) { return mask ? mask[voxel] != 0 : intensities[voxel] > lower; };
  m_Data.reset(static_cast<std::uint16_t *>(AllocateHuge(voxels * RecordLength * sizeof(std::uint16_t))));

  std::vector<SliceSums> sums(size[2]);
  const std::size_t      depth = std::max<std::size_t>(1, SlabVoxels / sliceLength);
  for (std::size_t first = 0; first < size[2]; first += depth)
  {
    const RecordSlab             slab(first, depth, size[2]);
    const VolumeView             part(intensities + slab.outerFirst * sliceLength,
                          { size[0], size[1], slab.outerEnd - slab.outerFirst },
                          edges.volume.spacing);
    const VolumeGradientOperator volumeGradient(
      part, edges.options, VolumeGradientOperator::Conductance::Published); // the weights alone
    ParallelFor(slab.end - slab.first, [&](std::size_t slice) {
      const std::size_t z = slab.first + slice;
      SliceSums &       sum = sums[z];
      Checksum          checksum;
      for (std::size_t y = 0; y < size[1]; ++y)
      {
        const std::size_t     begin = z * sliceLength + y * size[0];
        std::uint16_t * const row = m_Data.get() + begin * RecordLength;
        std::fill_n(row, size[0] * RecordLength, std::uint16_t{ 0 });
        FillRow(volumeGradient, y, z - slab.outerFirst, row);
        for (std::size_t x = 0; x < size[0]; ++x)
        {
          std::uint16_t * const record = row + x * RecordLength;
          const std::uint32_t   weights = SumOf(record);
          const bool            object = isObject(begin + x);
          record[MarksOfRecord] = static_cast<std::uint16_t>((object ? ObjectMark : 0) | (weights == 0 ? TrapMark : 0));
          sum.objectVoxels += object;
          sum.greatestSum = std::max(sum.greatestSum, weights);
        }
        checksum.Add(row, size[0] * RecordLength * sizeof(std::uint16_t));
      }
      sum.checksum = checksum.Get();
    });
    poll();
  }
  Checksum whole;
  for (const SliceSums & sum : sums)
  {
    m_ObjectVoxels += sum.objectVoxels;
    m_GreatestSum = std::max(m_GreatestSum, sum.greatestSum);
    whole.Add(&sum.checksum, sizeof(sum.checksum));
  }
  m_Checksum = whole.Get();
  if (m_ObjectVoxels == 0) // a constant volume: all voxels count
  {
    m_ObjectVoxels = voxels;
    for (std::size_t voxel = 0; voxel < voxels; ++voxel)
    {
      m_Data[voxel * RecordLength + MarksOfRecord] |= ObjectMark;
    }
  }
}

std::uint32_t
ParticleRecords::GetInitialHeat(std::size_t voxel) const
{
  return m_GreatestSum - SumOf(this->GetRecord(voxel));
}

const std::uint16_t *
ParticleRecords::GetRecord(std::size_t voxel) const
{
  return m_Data.get() + voxel * RecordLength;
}

void
ParticleRecords::Free::operator()(std::uint16_t * data) const
{
  std::free(data);
}
} // namespace shapeton
