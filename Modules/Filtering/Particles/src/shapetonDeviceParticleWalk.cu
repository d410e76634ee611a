// Contains only kernel launches; the arithmetic is shared with the CPU.
#include "shapetonDeviceParticleWalk.h"
#include "shapetonDeviceRuntime.h"
#include "shapetonPlaceInVoxel.h"
#include "shapetonParticleArithmetic.h"
#include "shapetonParticlePath.h"

#include <memory>

namespace shapeton
{
namespace
{
using namespace ParticleKernels;
using DeviceRuntime::Memory;
using Arithmetic = ParticleArithmetic<ScalarLanes>;

/** Several steps of a shapeton, in one launch because shapetons are independent and only add visits. */
template <Sampling VSampling, bool VTraversal>
struct Walk
{
  Surroundings       surroundings;
  ParticleArrays     arrays;
  const ThetaTable * table;
  std::uint64_t      seed;
  std::size_t        first;
  std::uint64_t      begin;
  std::uint64_t      end;

  SHAPETON_HOST_DEVICE void
  operator()(std::size_t number, ParticleTally & tally) const
  {
    const std::size_t i = first + number;
    std::uint32_t     voxel = arrays.voxels[i];
    float             place[3] = { arrays.places[0][i], arrays.places[1][i], arrays.places[2][i] };
    for (std::uint64_t step = begin; step < end; ++step)
    {
      const Random random{ seed, step };
      float        direction[3];
      Arithmetic::DrawDirection<VSampling>(
        surroundings.records, &voxel, random, static_cast<std::uint32_t>(i), *table, direction);
      voxel = Move(static_cast<std::uint32_t>(i), voxel, random, direction, place);
      const std::uint16_t marks = surroundings.records[std::size_t{ voxel } * RecordLength + MarksOfRecord];
      tally.Count(DeviceRuntime::CountOne(arrays.visits + voxel), (marks & ObjectMark) != 0);
    }
    arrays.voxels[i] = voxel;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      arrays.places[axis][i] = place[axis];
    }
  }

  /** Returns the new voxel. */
  SHAPETON_HOST_DEVICE std::uint32_t
  Move(std::uint32_t shapeton, std::uint32_t voxel, const Random & random, const float direction[3], float place[3])
    const
  {
    if constexpr (VTraversal)
    {
      Path path = Begin(surroundings, shapeton, voxel, random, direction);
      while (GoOn(surroundings, path))
      {}
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        place[axis] = PlaceInVoxel(static_cast<std::uint32_t>(path.index[axis]), path.place[axis]);
      }
      return path.voxel;
    }
    else
    {
      return static_cast<std::uint32_t>(Arithmetic::MovePlace(surroundings, direction, place));
    }
  }
};

struct SumOfShapetons
{
  Surroundings   surroundings;
  ParticleArrays arrays;

  SHAPETON_HOST_DEVICE void
  operator()(std::size_t i, ParticleSum & sum) const
  {
    const std::uint32_t voxel = arrays.voxels[i];
    const std::uint16_t marks = surroundings.records[std::size_t{ voxel } * RecordLength + MarksOfRecord];
    sum.Add({ arrays.visits[voxel], (marks & TrapMark) != 0 ? 1U : 0U });
  }
};

class WalkOnDevice : public DeviceParticleWalk
{
public:
  explicit WalkOnDevice(const DeviceParticleSettings & settings)
    : m_Settings(settings)
    , m_Voxels(std::size_t(settings.surroundings.size[0]) * settings.surroundings.size[1] *
               settings.surroundings.size[2])
    , m_Records(m_Voxels * RecordLength)
    , m_Table(1)
    , m_VoxelsOfShapetons(settings.shapetons)
    , m_Visits(m_Voxels)
  {
    m_Records.Upload(settings.surroundings.records);
    m_Table.Upload(settings.table);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      m_Places[axis] = Memory<float>(settings.shapetons);
      m_Arrays.places[axis] = m_Places[axis].Get();
    }
    m_Arrays.voxels = m_VoxelsOfShapetons.Get();
    m_Arrays.visits = m_Visits.Get();
    m_Settings.surroundings.records = m_Records.Get();
    m_Settings.surroundings.visits = m_Visits.Get();
  }

  void
  Upload(const ParticleArrays & host) override
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      m_Places[axis].Upload(host.places[axis]);
    }
    m_VoxelsOfShapetons.Upload(host.voxels);
    m_Visits.Upload(host.visits);
  }

  void
  Download(const ParticleArrays & host) const override
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      m_Places[axis].Download(host.places[axis]);
    }
    m_VoxelsOfShapetons.Download(host.voxels);
    m_Visits.Download(host.visits);
  }

  ParticleTally
  TakeSteps(std::size_t first, std::size_t number, std::uint64_t begin, std::uint64_t end) override
  {
    switch (m_Settings.sampling)
    {
      case Sampling::SolidAngle:
        return this->TakeSteps<Sampling::SolidAngle>(first, number, begin, end);
      case Sampling::SectorArea:
        return this->TakeSteps<Sampling::SectorArea>(first, number, begin, end);
      case Sampling::BinarySearch:
        return this->TakeSteps<Sampling::BinarySearch>(first, number, begin, end);
      default:
        return this->TakeSteps<Sampling::Uniform>(first, number, begin, end);
    }
  }

  ParticleSum
  SumOverShapetons() override
  {
    return DeviceRuntime::Reduce<ParticleSum>(m_Settings.shapetons,
                                              SumOfShapetons{ m_Settings.surroundings, m_Arrays });
  }

private:
  template <Sampling VSampling>
  ParticleTally
  TakeSteps(std::size_t first, std::size_t number, std::uint64_t begin, std::uint64_t end)
  {
    return m_Settings.traversal ? this->Launch<VSampling, true>(first, number, begin, end)
                                : this->Launch<VSampling, false>(first, number, begin, end);
  }

  template <Sampling VSampling, bool VTraversal>
  ParticleTally
  Launch(std::size_t first, std::size_t number, std::uint64_t begin, std::uint64_t end)
  {
    const Walk<VSampling, VTraversal> walk{
      m_Settings.surroundings, m_Arrays, m_Table.Get(), m_Settings.seed, first, begin, end
    };
    return DeviceRuntime::Reduce<ParticleTally>(number, walk);
  }

  DeviceParticleSettings m_Settings;
  std::size_t            m_Voxels;
  Memory<std::uint16_t>  m_Records;
  Memory<ThetaTable>     m_Table;
  Memory<std::uint32_t>  m_VoxelsOfShapetons;
  Memory<std::uint32_t>  m_Visits;
  Memory<float>          m_Places[3];
  ParticleArrays         m_Arrays{};
};
} // namespace

SHAPETON_DEVICE_FUNCTION DeviceParticleWalk *
ShapetonMakeWalk(const DeviceParticleSettings & settings)
{
  return new WalkOnDevice(settings);
}
} // namespace shapeton
