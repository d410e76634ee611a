#include "shapetonParticleWalk.h"

#include "shapetonKernelSets.h"
#include "shapetonParallelFor.h"
#include "shapetonParticlePlacement.h"
#include "shapetonParticleTraversal.h"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace shapeton
{
using namespace ParticleKernels;

namespace
{
/** Number of shapetons moved together; the data of each is prefetched while the others move. */
constexpr std::size_t GroupSize = 256;

const ThetaTable &
SharedThetaTable()
{
  static const ThetaTable table;
  return table;
}

/** For small groups a second thread does not pay off. */
unsigned int
WorkersFor(std::uint64_t shapetonSteps)
{
  return static_cast<unsigned int>(std::clamp<std::uint64_t>(shapetonSteps / 4096, 1, NumberOfThreads()));
}
} // namespace

ParticleWalk::ParticleWalk(const EdgeVolume &               edges,
                           const ParticleDiffusionOptions & given,
                           const unsigned char *            mask,
                           std::uint32_t *                  visitsOfVoxels,
                           const std::function<void()> &    poll)
  : settings(given)
  , window(*edges.options.intensityWindow)
  , size(edges.volume.size)
  , spacing(edges.volume.spacing)
  , visits(visitsOfVoxels)
  , kernels(BestKernels<Set>())
  , table(SharedThetaTable())
  , records(edges, mask, poll)
{
  DescribeSurroundings();
  const std::size_t length = (settings.shapetons + Granularity - 1) / Granularity * Granularity;
  for (auto & axis : places)
  {
    axis.assign(length, 0.0F);
  }
  voxels.assign(length, 0);
  ParallelFor(size[2], [this](std::size_t z) { std::fill_n(visits + z * size[0] * size[1], size[0] * size[1], 0U); });
  poll();
  Place(mask);
  ChooseDevice();
}

void
ParticleWalk::DescribeSurroundings()
{
  const double side = std::max({ size[0] * spacing[0], size[1] * spacing[1], size[2] * spacing[2] });
  surroundings.records = records.GetData();
  surroundings.visits = visits;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    surroundings.size[axis] = static_cast<std::int32_t>(size[axis]);
    surroundings.step[axis] = static_cast<float>(settings.distance * side / spacing[axis]);
  }
}

void
ParticleWalk::Place(const unsigned char * mask)
{
  const Shapetons all = Group(0, settings.shapetons);
  const bool      byInitialHeat = settings.placement == ParticlePlacement::InitialHeat;
  if (byInitialHeat || mask)
  {
    PlaceByDensity(surroundings, all, settings.seed, records, byInitialHeat, mask);
  }
  else
  {
    PlaceUniformly(surroundings, all, settings.seed);
  }
}

Shapetons
ParticleWalk::Group(std::size_t first, std::size_t number)
{
  return { static_cast<std::uint32_t>(first), number,
           places[0].data() + first,          places[1].data() + first,
           places[2].data() + first,          voxels.data() + first };
}

void
ParticleWalk::Move(const Shapetons & group, std::uint64_t step) const
{
  alignas(64) float components[3][GroupSize];
  const Directions  directions{ components[0], components[1], components[2] };
  const Random      random{ settings.seed, step };
  kernels.DrawOf(settings.directionSampling)(surroundings, group, random, table, directions);
  if (settings.pathRule == PathRule::Traversal)
  {
    TraverseVoxels(surroundings, group, random, directions);
  }
  else
  {
    kernels.move(surroundings, group, directions);
  }
}

template <bool VShared>
ParticleTally
ParticleWalk::Count(const Shapetons & group) const
{
  ParticleTally tally;
  for (std::size_t i = 0; i < group.number; ++i)
  {
    const std::uint32_t voxel = group.voxel[i];
    std::uint32_t       old = 0;
    if constexpr (VShared)
    {
      old = __atomic_fetch_add(visits + voxel, 1U, __ATOMIC_RELAXED);
    }
    else
    {
      old = visits[voxel]++;
    }
    tally.sumOfOld += old;
    tally.maximum = std::max(tally.maximum, old + 1);
    if (old == 0) // rare, so the record is read only then
    {
      ++tally.reached;
      tally.objectsReached += records.GetRecord(voxel)[MarksOfRecord] & ObjectMark;
    }
  }
  return tally;
}

template <typename TBody>
void
ParticleWalk::ForGroups(std::size_t first, std::size_t number, std::uint64_t shapetonSteps, const TBody & body)
{
  const std::size_t        groups = (number + GroupSize - 1) / GroupSize;
  std::atomic<std::size_t> next{ 0 };
  const unsigned int       workers = WorkersFor(shapetonSteps);
  ParallelWorkers(workers, [&](unsigned int) {
    for (std::size_t i = next++; i < groups; i = next++)
    {
      const std::size_t begin = i * GroupSize;
      body(Group(first + begin, std::min(GroupSize, number - begin)), workers > 1);
    }
  });
}

ParticleTally
ParticleWalk::TakeSteps(std::size_t first, std::size_t number, std::uint64_t begin, std::uint64_t end)
{
  if (m_Device)
  {
    return m_Device->TakeSteps(first, number, begin, end);
  }
  ParticleTally whole;
  std::mutex    mutex;
  ForGroups(first, number, number * (end - begin), [&](const Shapetons & group, bool shared) {
    ParticleTally tally;
    for (std::uint64_t step = begin; step < end; ++step)
    {
      Move(group, step);
      tally.Add(shared ? Count<true>(group) : Count<false>(group));
    }
    const std::lock_guard<std::mutex> lock(mutex);
    whole.Add(tally);
  });
  return whole;
}

ParticleSum
ParticleWalk::SumOverShapetons()
{
  if (m_Device)
  {
    return m_Device->SumOverShapetons();
  }
  ParticleSum whole;
  std::mutex  mutex;
  ForGroups(0, settings.shapetons, settings.shapetons, [&](const Shapetons & group, bool) {
    ParticleSum sum;
    for (std::size_t i = 0; i < group.number; ++i)
    {
      sum.visits += visits[group.voxel[i]];
      sum.trapped += (records.GetRecord(group.voxel[i])[MarksOfRecord] & TrapMark) != 0;
    }
    const std::lock_guard<std::mutex> lock(mutex);
    whole.Add(sum);
  });
  return whole;
}

void
ParticleWalk::ChooseDevice()
{
  const std::size_t bytes = NumberOfVoxels() * (RecordLength * sizeof(std::uint16_t) + sizeof(std::uint32_t)) +
                            std::size_t{ settings.shapetons } * 4 * sizeof(float) + (std::size_t{ 1 } << 20);
  deviceUse = shapeton::ChooseDevice(settings.device, bytes);
  if (!deviceUse.gpu)
  {
    return;
  }
  const auto make = reinterpret_cast<MakeDeviceParticleWalkFunction *>(FindDeviceFunction("ShapetonMakeWalk"));
  m_Device.reset(make({ surroundings,
                        &table,
                        settings.directionSampling,
                        settings.pathRule == PathRule::Traversal,
                        settings.shapetons,
                        settings.seed }));
  SendToDevice();
}

void
ParticleWalk::SendToDevice()
{
  if (m_Device)
  {
    m_Device->Upload({ { places[0].data(), places[1].data(), places[2].data() }, voxels.data(), visits });
  }
}

void
ParticleWalk::FetchFromDevice()
{
  if (m_Device)
  {
    m_Device->Download({ { places[0].data(), places[1].data(), places[2].data() }, voxels.data(), visits });
  }
}
} // namespace shapeton
