#include "shapetonSeededHeatSolver.h"

#include "shapetonExceptions.h"
#include "shapetonHeatMultigrid.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <bitset>
#include <numeric>
#include <set>

namespace shapeton
{
namespace
{
// The preconditioner estimates the error; measured errors are up to four times larger.
constexpr double safety = 0.1;

/** The labels of seeds and, unless null, those before. */
std::vector<unsigned short>
LabelsOf(const unsigned short * seeds, const unsigned short * before, std::size_t number)
{
  std::bitset<65536> isSeed;
  for (std::size_t i = 0; i < number; ++i)
  {
    isSeed.set(seeds[i]);
    isSeed.set(before ? before[i] : 0);
  }
  std::vector<unsigned short> labels;
  for (unsigned int label = 1; label < 65536; ++label)
  {
    if (isSeed[label])
    {
      labels.push_back(static_cast<unsigned short>(label));
    }
  }
  return labels;
}
} // namespace

/** Labels that are solved in one pass, and their potentials. */
struct SeededHeatSolver::Batch
{
  std::vector<unsigned short> labels;
  int                         width; ///< 1, 2 or 4: lanes beyond the labels stay 0
  LabelField                  potentials;
};

SeededHeatSolver::SeededHeatSolver(const VolumeGradientOperator & volumeGradient, const SeededHeatOptions & settings)
  : m_VolumeGradient(volumeGradient), m_Settings(settings)
{
  RequireParameter(settings.tolerance >= 1e-6 && settings.tolerance <= 0.1,
                   "the parameter \"tolerance\" must be between 1e-6 and 0.1");
  RequireParameter(volumeGradient.GetLeastWeight() > 0.0,
                   "the parameter \"leastWeight\" of the volume gradient operator must be positive, because heat "
                   "must reach every voxel");
}

SeededHeatSolver::~SeededHeatSolver() = default;

/** Sets the heat of seeds, also in potentials of an earlier solution. */
void
SeededHeatSolver::SetSeedValues(Batch & batch, const unsigned short * seeds) const
{
  const PaddedGrid & grid = m_VolumeGradient.GetGrid();
  const auto         size = grid.GetSize();
  ParallelFor(size[1] * size[2], [&](std::size_t row) {
    const unsigned short * const given = seeds + row * size[0];
    float * const values = batch.potentials.GetData() + grid.GetRow(static_cast<std::ptrdiff_t>(row % size[1]),
                                                                    static_cast<std::ptrdiff_t>(row / size[1])) *
                                                          static_cast<std::size_t>(batch.width);
    for (std::size_t x = 0; x < size[0]; ++x)
    {
      for (std::size_t l = 0; given[x] != 0 && l < batch.labels.size(); ++l)
      {
        values[x * static_cast<std::size_t>(batch.width) + l] = given[x] == batch.labels[l] ? 1.0F : 0.0F;
      }
    }
  });
}

template <int VLabels>
void
SeededHeatSolver::SolveBatch(Batch &                      batch,
                             const unsigned short *       seeds,
                             const ConductanceHierarchy & hierarchy,
                             const Progress &             progress)
{
  this->SetSeedValues(batch, seeds);
  LabelField             residuals(batch.potentials.GetLength());
  HeatMultigrid<VLabels> multigrid(hierarchy);
  multigrid.SubtractImage(batch.potentials, residuals);
  for (const SeedEdge & edge : hierarchy.GetFinest().seedEdges)
  {
    for (std::size_t l = 0; l < batch.labels.size(); ++l)
    {
      residuals.GetData()[edge.voxel * VLabels + l] += edge.label == batch.labels[l] ? edge.conductance : 0.0F;
    }
  }
  const unsigned int iterations = multigrid.Solve(batch.potentials, residuals, safety * m_Settings.tolerance, progress);
  m_Result.iterations = std::max(m_Result.iterations, iterations);
}

/** Updates the two greatest probabilities of each voxel with the labels of a batch. */
void
SeededHeatSolver::Compare(const Batch & batch)
{
  const PaddedGrid & grid = m_VolumeGradient.GetGrid();
  const auto         size = grid.GetSize();
  ParallelFor(size[1] * size[2], [&](std::size_t row) {
    const float * const values = batch.potentials.GetData() + grid.GetRow(static_cast<std::ptrdiff_t>(row % size[1]),
                                                                          static_cast<std::ptrdiff_t>(row / size[1])) *
                                                                static_cast<std::size_t>(batch.width);
    for (std::size_t x = 0; x < size[0]; ++x)
    {
      const std::size_t i = row * size[0] + x;
      for (std::size_t l = 0; l < batch.labels.size(); ++l)
      {
        const float value = std::clamp(values[x * static_cast<std::size_t>(batch.width) + l], 0.0F, 1.0F);
        m_Sum[i] += value;
        if (value > m_Best[i])
        {
          m_Second[i] = m_Best[i];
          m_Best[i] = value;
          m_Result.labels[i] = batch.labels[l];
        }
        else
        {
          m_Second[i] = std::max(m_Second[i], value);
        }
      }
    }
  });
}

/** No label is probable where no path of edges leads to a seed. */
void
SeededHeatSolver::ExcludeUnreached(const unsigned short * seeds, const unsigned short * before)
{
  const PaddedGrid &         grid = m_VolumeGradient.GetGrid();
  const auto &               size = grid.GetSize();
  std::vector<unsigned char> isReached(grid.GetLength(), 1); // outside the volume, so nothing is reached there
  std::vector<std::size_t>   front;
  const auto                 placeOf = [&](std::size_t voxel) {
    const std::size_t row = voxel / size[0];
    return grid.GetRow(static_cast<std::ptrdiff_t>(row % size[1]), static_cast<std::ptrdiff_t>(row / size[1])) +
           voxel % size[0];
  };
  const auto reach = [&](std::size_t place) {
    if (isReached[place] == 0)
    {
      isReached[place] = 1;
      front.push_back(place);
    }
  };
  for (std::size_t voxel = 0; voxel < m_Sum.size(); ++voxel)
  {
    isReached[placeOf(voxel)] = 0;
  }
  for (std::size_t voxel = 0; voxel < m_Sum.size(); ++voxel)
  {
    if (seeds[voxel] != 0 || (before && before[voxel] != 0))
    {
      reach(placeOf(voxel));
    }
  }
  while (!front.empty())
  {
    const std::size_t place = front.back();
    front.pop_back();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const float * const c = m_VolumeGradient.GetConductances(axis);
      const std::size_t   stride = grid.GetStride(axis);
      if (c[place] > 0.0F)
      {
        reach(place + stride);
      }
      if (c[place - stride] > 0.0F)
      {
        reach(place - stride);
      }
    }
  }
  for (std::size_t voxel = 0; voxel < m_Sum.size(); ++voxel)
  {
    if (isReached[placeOf(voxel)] == 0)
    {
      m_Sum[voxel] = 1.0F; // so that nothing remains for the last label
      m_Best[voxel] = m_Second[voxel] = 0.0F;
      m_Result.labels[voxel] = 0;
    }
  }
}

/** The last label gets the remaining probability. */
void
SeededHeatSolver::Finish()
{
  const unsigned short last = m_Result.labelValues.back();
  ParallelForBlocks(m_Sum.size(), [&](std::size_t i) {
    const float value = std::max(0.0F, 1.0F - m_Sum[i]);
    if (value > m_Best[i])
    {
      m_Second[i] = m_Best[i];
      m_Best[i] = value;
      m_Result.labels[i] = last;
    }
    else
    {
      m_Second[i] = std::max(m_Second[i], value);
    }
    m_Result.uncertainty[i] = 1.0F - (m_Best[i] - m_Second[i]) / std::max(1.0F, m_Sum[i]);
  });
}

void
SeededHeatSolver::RemarkOnFewVoxels(const unsigned short * seeds)
{
  constexpr std::size_t    numberOfLabels = 65536;
  std::vector<std::size_t> own(numberOfLabels, 0);
  std::vector<std::size_t> gained(numberOfLabels, 0);
  for (std::size_t i = 0; i < m_Result.labels.size(); ++i)
  {
    ++(seeds[i] != 0 ? own[seeds[i]] : gained[m_Result.labels[i]]);
  }
  const std::size_t withoutSeed = std::accumulate(gained.begin(), gained.end(), std::size_t{ 0 });
  if (2 * withoutSeed < m_Result.labels.size())
  {
    return;
  }
  for (const unsigned short label : m_Result.labelValues)
  {
    if (gained[label] < SeededHeatResult::FewestVoxels)
    {
      m_Result.remarks.push_back("label " + std::to_string(label) + " has " + std::to_string(own[label]) +
                                 (own[label] == 1 ? " seed" : " seeds") + " and gains only " +
                                 std::to_string(gained[label]) +
                                 " voxels; if its region is larger, add strokes throughout it");
    }
  }
}

const SeededHeatResult &
SeededHeatSolver::Solve(const unsigned short * seeds, const Progress & progress, const unsigned short * before)
{
  const auto * const domain = m_VolumeGradient.GetDomain();
  if (!domain)
  {
    return this->SolveInDomain(seeds, before, progress);
  }
  const auto inDomain = [&](const unsigned short * labels) {
    std::vector<unsigned short> inside(labels ? domain->size() : 0);
    for (std::size_t voxel = 0; voxel < inside.size(); ++voxel)
    {
      inside[voxel] = (*domain)[voxel] != 0 ? labels[voxel] : 0;
    }
    return inside;
  };
  this->SolveInDomain(inDomain(seeds).data(), before ? inDomain(before).data() : nullptr, progress);
  std::set<unsigned short> lost(seeds, seeds + domain->size());
  lost.erase(0);
  for (const unsigned short label : m_Result.labelValues)
  {
    lost.erase(label);
  }
  for (const unsigned short label : lost)
  {
    m_Result.remarks.push_back("label " + std::to_string(label) +
                               " has no seed in the domain, and no voxel; move its seeds inside, or change the domain");
  }
  return m_Result;
}

const SeededHeatResult &
SeededHeatSolver::SolveInDomain(const unsigned short * seeds, const unsigned short * before, const Progress & progress)
{
  const PaddedGrid & grid = m_VolumeGradient.GetGrid();
  const std::size_t  number = grid.GetNumberOfVoxels();
  const auto         labels = LabelsOf(seeds, before, number);
  if (labels.size() < 2)
  {
    const std::string where = m_VolumeGradient.GetDomain() ? " in the domain" : "";
    throw InputError((labels.empty() ? "no voxel" + where + " has a seed"
                                     : "all seeds" + where + " have the label " + std::to_string(labels.front())) +
                     "; add seeds of at least two labels" + where);
  }
  if (grid.GetLength() >= noAggregate / 2)
  {
    throw InputError("the volume has more voxels than the solver supports; crop it or use larger voxels");
  }
  if (labels != m_Result.labelValues || !m_Settings.keepProbabilities)
  {
    m_Batches.clear();
  }
  m_Result = {};
  auto batches = std::move(m_Batches); // an abort invalidates the start solution
  m_Batches.clear();
  const ConductanceHierarchy hierarchy(m_VolumeGradient, seeds, before, progress.Part("", 0.0, 0.1));
  m_Result.labels.assign(number, labels.front());
  m_Result.uncertainty.assign(number, 0.0F);
  m_Result.labelValues = labels;
  m_Best.assign(number, 0.0F);
  m_Second.assign(number, 0.0F);
  m_Sum.assign(number, 0.0F);
  const std::size_t solved = labels.size() - 1;
  for (std::size_t first = 0, index = 0; first < solved; ++index)
  {
    const std::size_t width = solved - first >= 3 ? 4 : solved - first;
    const std::size_t end = std::min(solved, first + width);
    if (batches.size() <= index)
    {
      batches.push_back(
        { { labels.begin() + static_cast<std::ptrdiff_t>(first), labels.begin() + static_cast<std::ptrdiff_t>(end) },
          static_cast<int>(width),
          LabelField(grid.GetLength() * width) });
    }
    Batch &          batch = batches[index];
    constexpr double prepared = 0.1;
    const auto       share = [&](std::size_t label) {
      return prepared + (1.0 - prepared) * static_cast<double>(label) / solved;
    };
    const Progress part = progress.Part("", share(first), share(end));
    width == 4   ? this->SolveBatch<4>(batch, seeds, hierarchy, part)
    : width == 2 ? this->SolveBatch<2>(batch, seeds, hierarchy, part)
                 : this->SolveBatch<1>(batch, seeds, hierarchy, part);
    this->Compare(batch);
    if (!m_Settings.keepProbabilities)
    {
      batch.potentials = LabelField(0);
    }
    first = end;
  }
  if (m_VolumeGradient.GetDomain())
  {
    this->ExcludeUnreached(seeds, before);
  }
  this->Finish();
  if (!before)
  {
    this->RemarkOnFewVoxels(seeds);
  }
  if (m_Settings.keepProbabilities)
  {
    m_Batches = std::move(batches);
  }
  return m_Result;
}

void
SeededHeatSolver::GetProbabilities(unsigned short label, float * probabilities) const
{
  RequireParameter(!m_Batches.empty(), "the probabilities of the seeded heat were not kept");
  const PaddedGrid & grid = m_VolumeGradient.GetGrid();
  const auto         size = grid.GetSize();
  if (label == m_Result.labelValues.back())
  {
    std::transform(m_Sum.begin(), m_Sum.end(), probabilities, [](float sum) { return std::max(0.0F, 1.0F - sum); });
    return;
  }
  for (const Batch & batch : m_Batches)
  {
    const auto found = std::find(batch.labels.begin(), batch.labels.end(), label);
    if (found == batch.labels.end())
    {
      continue;
    }
    const auto lane = static_cast<std::size_t>(found - batch.labels.begin());
    const auto width = static_cast<std::size_t>(batch.width);
    ParallelFor(size[1] * size[2], [&](std::size_t row) {
      const std::size_t place =
        grid.GetRow(static_cast<std::ptrdiff_t>(row % size[1]), static_cast<std::ptrdiff_t>(row / size[1]));
      for (std::size_t x = 0; x < size[0]; ++x)
      {
        const std::size_t i = row * size[0] + x;
        const float       value = std::clamp(batch.potentials.GetData()[(place + x) * width + lane], 0.0F, 1.0F);
        probabilities[i] = value / std::max(1.0F, m_Sum[i]);
      }
    });
    return;
  }
  throw ParameterError("the label " + std::to_string(label) + " has no seed");
}
} // namespace shapeton
