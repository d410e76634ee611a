#include "shapetonCumulativeHeatDiffusion.h"
#include "shapetonExceptions.h"
#include "shapetonHeatClassification.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace shapeton
{
namespace
{
void
Unpad(const PaddedGrid & grid, const PaddedField & field, float * values)
{
  const auto & size = grid.GetSize();
  for (std::size_t z = 0; z < size[2]; ++z)
  {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      const float * const row = field.GetData() + grid.GetRow(y, z);
      std::copy(row, row + size[0], values + (z * size[1] + y) * size[0]);
    }
  }
}

void
CheckSteps(const std::string & name, const std::vector<std::uint64_t> & steps, std::uint64_t last)
{
  const bool ascend = std::adjacent_find(steps.begin(), steps.end(), std::greater_equal<>()) == steps.end();
  RequireParameter(ascend && (steps.empty() || steps.back() <= last),
                   name + " must be ascending and at most the parameter \"timeSteps\"");
}

void
CheckSettings(const VolumeView &                      volume,
              const CumulativeHeatDiffusionSettings & settings,
              const HeatSnapshotConsumer &            consumer)
{
  CheckSteps("the histogram steps", settings.histogramSteps, settings.timeSteps);
  CheckSteps("the parameter \"snapshotSteps\"", settings.snapshotSteps, settings.timeSteps);
  RequireParameter(settings.snapshotSteps.empty() || consumer, "snapshots are requested without a consumer");
  CheckOptions(settings);
  if (volume.NumberOfVoxels() >= std::numeric_limits<std::uint32_t>::max())
  {
    throw InputError("the volume has 2^32 voxels or more; crop it");
  }
}

VolumeGradientOperator
MakeOperator(const VolumeView &                      volume,
             const CumulativeHeatDiffusionSettings & settings,
             const Progress &                        progress,
             CumulativeHeatDiffusionResult &         result)
{
  EdgeVolume edges(volume, settings);
  result.p = settings.p;
  result.smoothing = settings.smoothing;
  result.windowLower = (*edges.options.intensityWindow)[0];
  result.windowUpper = (*edges.options.intensityWindow)[1];
  result.timeStepLength = settings.timeStepLength;
  if (settings.ignoreSpacing)
  {
    edges.volume.spacing = { { 1.0, 1.0, 1.0 } };
  }
  return VolumeGradientOperator(edges.volume, edges.options, settings.conductance, 0.0, progress);
}

/** The classes of the last row. */
std::vector<HeatClass>
FindCoherentClasses(const VolumeGradientOperator & volumeGradient, const float * heat)
{
  HeatHistogram row({ 0 });
  row.AddToRow(0, heat, volumeGradient.GetGrid().GetNumberOfVoxels());
  auto classes = FindHeatClasses(row, 0);
  MeasureCoherence(volumeGradient, heat, classes);
  return classes;
}

bool
IsZero(const PaddedGrid & grid, const PaddedField & field)
{
  const float * const data = field.GetData();
  return std::all_of(data, data + grid.GetLength(), [](float value) { return value == 0.0F; });
}

/** Distributes the solver's snapshots to histogram rows and whole volumes. */
class SnapshotSorter : public HeatSnapshots
{
public:
  SnapshotSorter(const PaddedGrid &                      grid,
                 const CumulativeHeatDiffusionSettings & settings,
                 const HeatSnapshotConsumer &            consumer)
    : m_RowLength(grid.GetSize()[0])
    , m_RowsPerVolume(grid.GetSize()[1] * grid.GetSize()[2])
    , m_Consumer(consumer)
    , m_Counts(NumberOfTables(settings.histogramSteps.size()))
  {
    std::set_union(settings.histogramSteps.begin(),
                   settings.histogramSteps.end(),
                   settings.snapshotSteps.begin(),
                   settings.snapshotSteps.end(),
                   std::back_inserter(m_Steps));
    m_Steps.erase(std::unique(m_Steps.begin(), m_Steps.end()), m_Steps.end());
    m_HistogramRow.assign(m_Steps.size(), -1);
    for (std::size_t row = 0; row < settings.histogramSteps.size(); ++row)
    {
      m_HistogramRow[this->Find(settings.histogramSteps[row])] = static_cast<std::ptrdiff_t>(row);
    }
    for (auto & table : m_Counts)
    {
      table.counts.assign(settings.histogramSteps.size() * HeatHistogram::NumberOfBins, 0);
    }
    for (const std::uint64_t step : settings.snapshotSteps)
    {
      m_Volumes[this->Find(step)] = std::make_unique<Volume>();
    }
  }

  const std::vector<std::uint64_t> &
  GetSteps() const
  {
    return m_Steps;
  }

  bool
  IsCounted(std::size_t snapshot) const override
  {
    return m_HistogramRow[snapshot] >= 0;
  }

  void
  CountRow(std::size_t snapshot, const float * heat, std::uint32_t weight, unsigned int worker) override
  {
    CountTable &                      table = m_Counts[worker % m_Counts.size()];
    const std::lock_guard<std::mutex> lock(table.mutex);
    HeatHistogram::CountHeats(heat, m_RowLength, CountsOf(table, snapshot), weight);
  }

  void
  AddCounts(std::size_t snapshot, const std::uint32_t * counts, std::uint32_t weight) override
  {
    std::uint32_t * const own = CountsOf(m_Counts.front(), snapshot);
    for (unsigned int bin = 0; bin < HeatHistogram::NumberOfBins; ++bin)
    {
      own[bin] += weight * counts[bin];
    }
  }

  bool
  IsShown(std::size_t snapshot) const override
  {
    return m_Volumes.count(snapshot) != 0;
  }

  void
  ShowRow(std::size_t snapshot, std::size_t row, const float * heat, unsigned int) override
  {
    Volume & volume = *m_Volumes.at(snapshot);
    std::call_once(volume.allocated, [&] { volume.heat.resize(m_RowLength * m_RowsPerVolume); });
    std::copy(heat, heat + m_RowLength, volume.heat.data() + row * m_RowLength);
    ++volume.rows;
  }

  /** Passes complete volumes to the consumer; called from a single thread between visits. */
  void
  Deliver()
  {
    for (auto volume = m_Volumes.begin(); volume != m_Volumes.end();)
    {
      if (volume->second->rows == m_RowsPerVolume)
      {
        m_Consumer(m_Steps[volume->first], volume->second->heat);
        volume = m_Volumes.erase(volume);
      }
      else
      {
        ++volume;
      }
    }
  }

  HeatHistogram
  MakeHistogram(const std::vector<std::uint64_t> & histogramSteps, std::uint64_t lastStep) const
  {
    const auto    end = std::upper_bound(histogramSteps.begin(), histogramSteps.end(), lastStep);
    HeatHistogram histogram(std::vector<std::uint64_t>(histogramSteps.begin(), end));
    for (const auto & table : m_Counts)
    {
      for (std::size_t row = 0; row < histogram.GetNumberOfRows(); ++row)
      {
        histogram.AddToRow(row, table.counts.data() + row * HeatHistogram::NumberOfBins);
      }
    }
    return histogram;
  }

private:
  struct Volume
  {
    std::once_flag           allocated;
    std::vector<float>       heat;
    std::atomic<std::size_t> rows{ 0 };
  };

  /** Counts of all rows; one copy per worker if memory allows. */
  struct CountTable
  {
    std::mutex                 mutex;
    std::vector<std::uint32_t> counts;
  };

  std::uint32_t *
  CountsOf(CountTable & table, std::size_t snapshot) const
  {
    return table.counts.data() + m_HistogramRow[snapshot] * HeatHistogram::NumberOfBins;
  }

  /** One copy per thread, up to 256 MB in total. */
  static std::size_t
  NumberOfTables(std::size_t rows)
  {
    constexpr std::size_t budget = std::size_t{ 1 } << 28;
    const std::size_t     bytes = std::max<std::size_t>(1, rows * HeatHistogram::NumberOfBins * sizeof(std::uint32_t));
    return rows == 0 ? 0 : std::clamp<std::size_t>(budget / bytes, 1, NumberOfThreads());
  }

  std::size_t
  Find(std::uint64_t step) const
  {
    return std::lower_bound(m_Steps.begin(), m_Steps.end(), step) - m_Steps.begin();
  }

  std::size_t                                    m_RowLength;
  std::size_t                                    m_RowsPerVolume;
  const HeatSnapshotConsumer &                   m_Consumer;
  std::vector<std::uint64_t>                     m_Steps;
  std::vector<std::ptrdiff_t>                    m_HistogramRow; // histogram row of each step, or -1
  std::vector<CountTable>                        m_Counts;
  std::map<std::size_t, std::unique_ptr<Volume>> m_Volumes;
};
} // namespace

CumulativeHeatDiffusionResult
DiffuseCumulativeHeat(VolumeView                              volume,
                      const CumulativeHeatDiffusionSettings & settings,
                      float *                                 heat,
                      float *                                 initialHeat,
                      const HeatSnapshotConsumer &            consumer,
                      const Progress &                        progress)
{
  CheckSettings(volume, settings, consumer);
  CumulativeHeatDiffusionResult result;
  // Preparation is fast, so it does not report progress, but can be aborted.
  const Progress               preparation = progress.Part("", 0.0, 0.0);
  const VolumeGradientOperator volumeGradient = MakeOperator(volume, settings, preparation, result);
  volume.own.reset();
  HeatDiffusionSolver solver(volumeGradient, settings.solver, settings.timeStepLength, settings.tolerance);
  if (settings.untilSteady)
  {
    solver.StopWhenSteady({});
  }
  PaddedField field(volumeGradient.GetGrid());
  volumeGradient.ComputeInitialHeat(field);
  result.cold = IsZero(volumeGradient.GetGrid(), field);
  preparation(0.0);

  if (settings.wantComponents)
  {
    result.components = FindShapeComponents(volumeGradient, field, volume.spacing, settings.minimumComponentVoxels);
  }
  if (initialHeat)
  {
    Unpad(volumeGradient.GetGrid(), field, initialHeat);
  }
  SnapshotSorter sorter(volumeGradient.GetGrid(), settings, consumer);
  solver.SetProgress([&](double share) {
    sorter.Deliver();
    progress(share);
  });
  solver.SetDevice(settings.device);
  result.timeStep = solver.Run(field, settings.timeSteps, sorter.GetSteps(), sorter);
  result.device = solver.GetDeviceUse().Describe();
  sorter.Deliver();
  Unpad(volumeGradient.GetGrid(), field, heat);
  if (settings.wantComponents)
  {
    result.classes = FindCoherentClasses(volumeGradient, heat);
  }
  result.steady = solver.IsSteady();
  result.operatorApplications = solver.GetNumberOfApplications();
  result.histogram = sorter.MakeHistogram(settings.histogramSteps, result.timeStep);
  return result;
}
} // namespace shapeton
