#include "shapetonHeatEngineOnGpu.h"
#include "shapetonDeviceHeatEngine.h"
#include "shapetonHeatEngineOnCpu.h"

#include <algorithm>

namespace shapeton
{
namespace
{
using Field = HeatEngine::Field;

/** Number of steps per slab visit. This is also the number of overlap slices on each side, whose values become invalid.
 * */
constexpr unsigned int SlabSteps = 32;

/** Bytes of all fields, one extra output field and conductances for a number of slices, plus sums and counts. */
std::size_t
BytesOfSlices(const PaddedGrid & grid, std::size_t slices)
{
  const PaddedGrid part({ grid.GetSize()[0], grid.GetSize()[1], slices });
  return part.GetLength() * sizeof(float) * (HeatEngine::MostFields + 1 + 3) + (std::size_t{ 16 } << 20);
}

/** Minimum thickness of a slab with its overlap on both sides. */
std::size_t
LeastSlices(const PaddedGrid & grid)
{
  return std::min<std::size_t>(grid.GetSize()[2], 4 * SlabSteps);
}

/** The number of slices that fit; at least LeastSlices(), see ChooseDeviceForHeat(). */
std::size_t
SlicesThatFit(const PaddedGrid & grid, std::size_t memory)
{
  std::size_t slices = grid.GetSize()[2];
  while (slices > LeastSlices(grid) && BytesOfSlices(grid, slices) > memory)
  {
    --slices;
  }
  return slices;
}

std::unique_ptr<DeviceHeatEngine>
MakeDeviceEngine(const DeviceHeatVolume & volume, float * heat, HeatSnapshots * snapshots)
{
  const auto make = reinterpret_cast<MakeDeviceHeatEngineFunction *>(FindDeviceFunction("ShapetonMakeHeatEngine"));
  return std::unique_ptr<DeviceHeatEngine>(make(volume, heat, snapshots));
}

/** Slices of the volume on the GPU: `first` to `end`, of which `ownFirst` to `ownEnd` are valid after SlabSteps
 * steps. */
struct Slab
{
  Slab(std::size_t begin, std::size_t number, std::size_t slices)
    : ownFirst(begin)
    , ownEnd(std::min(begin + number, slices))
    , first(begin < SlabSteps ? 0 : begin - SlabSteps)
    , end(std::min(ownEnd + SlabSteps, slices))
  {}

  std::size_t ownFirst;
  std::size_t ownEnd;
  std::size_t first;
  std::size_t end;
};

/** \class SlabEngine
 * \brief Engine for volumes larger than GPU memory: the GPU computes the steps slab by slab, and the CPU does
 * everything else.
 *
 * Values beyond a slab do not change during its steps, so each step invalidates one more slice from its border.
 * These slices overlap the adjacent slabs and are not copied back. */
class SlabEngine : public HeatEngineOnCpu
{
public:
  SlabEngine(std::size_t                    slices,
             const VolumeGradientOperator & volumeGradient,
             PaddedField &                  heat,
             HeatSnapshots &                snapshots,
             const std::function<void()> &  allocated)
    : HeatEngineOnCpu(volumeGradient, heat, snapshots, allocated)
    , m_OwnSlices(std::max<std::size_t>(1, slices - 2 * SlabSteps))
  {}

  unsigned int
  GetLongestStretch(bool) const override
  {
    return SlabSteps;
  }

  void
  StepExplicitly(unsigned int steps, float dt, bool compensated) override
  {
    this->ForSlabs([&](const Slab & slab, DeviceHeatEngine & engine) {
      this->Upload(slab, engine, Heat, Heat);
      if (compensated)
      {
        this->Upload(slab, engine, Odd, Odd);
      }
      engine.StepExplicitly(steps, dt, compensated);
      this->Download(slab, engine, Heat, Even);
      if (compensated)
      {
        this->Download(slab, engine, Odd, NextOdd);
      }
    });
    this->Exchange(Heat, Even);
    if (compensated)
    {
      this->Exchange(Odd, NextOdd);
    }
  }

  void
  StepChebyshev(std::size_t done, unsigned int steps, float scale, const Expansions & coefficients, SliceStride stride)
    override
  {
    this->ForSlabs([&](const Slab & slab, DeviceHeatEngine & engine) {
      this->Upload(slab, engine, Even, Even);
      this->Upload(slab, engine, Difference, Difference);
      for (Field node = FirstNode; node < FirstNode + coefficients.size(); ++node)
      {
        this->Upload(slab, engine, node, node);
      }
      engine.StepChebyshev(done, steps, scale, coefficients, stride);
      this->Download(slab, engine, Even, Odd);
      this->Download(slab, engine, Difference, NextDifference);
      for (Field node = FirstNode; node < FirstNode + coefficients.size(); ++node)
      {
        this->Download(slab, engine, node, node);
      }
    });
    this->Exchange(Even, Odd);
    this->Exchange(Difference, NextDifference);
  }

private:
  // Results must not overwrite the input of the next slab.
  static constexpr Field NextOdd = MostFields;
  static constexpr Field NextDifference = MostFields;

  template <typename TBody>
  void
  ForSlabs(const TBody & body)
  {
    const auto & size = m_Grid.GetSize();
    for (std::size_t begin = 0; begin < size[2]; begin += m_OwnSlices)
    {
      const Slab             slab(begin, m_OwnSlices, size[2]);
      const std::size_t      skipped = slab.first * m_Grid.GetStride(2);
      const DeviceHeatVolume volume{ PaddedGrid({ size[0], size[1], slab.end - slab.first }),
                                     { m_VolumeGradient.GetConductances(0) + skipped,
                                       m_VolumeGradient.GetConductances(1) + skipped,
                                       m_VolumeGradient.GetConductances(2) + skipped } };
      const auto             engine = MakeDeviceEngine(volume, nullptr, nullptr);
      body(slab, *engine);
    }
  }

  void
  Upload(const Slab & slab, DeviceHeatEngine & engine, Field from, Field to)
  {
    engine.Upload(to, this->Get(from) + slab.first * m_Grid.GetStride(2));
  }

  void
  Download(const Slab & slab, DeviceHeatEngine & engine, Field from, Field to)
  {
    engine.Download(
      from, this->Get(to) + slab.first * m_Grid.GetStride(2), slab.ownFirst - slab.first, slab.ownEnd - slab.ownFirst);
  }

  std::size_t m_OwnSlices;
};
} // namespace

DeviceUse
ChooseDeviceForHeat(Device wanted, const PaddedGrid & grid)
{
  return ChooseDevice(wanted, BytesOfSlices(grid, grid.GetSize()[2]), BytesOfSlices(grid, LeastSlices(grid)));
}

std::unique_ptr<HeatEngine>
MakeHeatEngineOnGpu(const DeviceUse &              use,
                    const VolumeGradientOperator & volumeGradient,
                    PaddedField &                  heat,
                    HeatSnapshots &                snapshots,
                    const std::function<void()> &  allocated)
{
  const PaddedGrid & grid = volumeGradient.GetGrid();
  const std::size_t  slices = SlicesThatFit(grid, use.memory);
  if (slices < grid.GetSize()[2])
  {
    return std::make_unique<SlabEngine>(slices, volumeGradient, heat, snapshots, allocated);
  }
  return MakeDeviceEngine(
    { grid,
      { volumeGradient.GetConductances(0), volumeGradient.GetConductances(1), volumeGradient.GetConductances(2) } },
    heat.GetData(),
    &snapshots);
}
} // namespace shapeton
