#include "shapetonHeatEngineOnCpu.h"
#include "shapetonDiffusionKernels.h"
#include "shapetonKernelSets.h"
#include "shapetonTimeTiles.h"

#include <cstring>
#include <numeric>

namespace shapeton
{
namespace
{
// Measured on 256^3: all fields of a tile stay in the cache while it advances.
constexpr TimeTileShape explicitTile{ 32, 32, 16 };
constexpr TimeTileShape chebyshevTile{ 16, 16, 8 };

const DiffusionKernels::Set &
Kernels()
{
  return BestKernels<DiffusionKernels::Set>();
}

DiffusionKernels::Edges
EdgesOfRow(const VolumeGradientOperator & op, std::size_t row)
{
  return { op.GetConductances(0) + row,
           op.GetConductances(1) + row,
           op.GetConductances(2) + row,
           static_cast<std::ptrdiff_t>(op.GetGrid().GetStride(1)),
           static_cast<std::ptrdiff_t>(op.GetGrid().GetStride(2)) };
}

/** Calls body(row number, memory index, worker) for all rows of every n-th slice, in parallel over slices. */
template <typename TBody>
void
ForAllRows(const PaddedGrid & grid, HeatEngine::SliceStride stride, const TBody & body)
{
  const std::size_t ny = grid.GetSize()[1];
  const std::size_t slices = (grid.GetSize()[2] + stride - 1) / stride;
  ParallelForWorkers(slices, [&](std::size_t slice, unsigned int worker) {
    const FlushToZero flushToZero;
    const std::size_t z = slice * stride;
    for (std::size_t y = 0; y < ny; ++y)
    {
      body(y + ny * z, grid.GetRow(y, z), worker);
    }
  });
}
} // namespace

HeatEngineOnCpu::HeatEngineOnCpu(const VolumeGradientOperator & volumeGradient,
                                 PaddedField &                  heat,
                                 HeatSnapshots &                snapshots,
                                 std::function<void()>          allocated)
  : m_VolumeGradient(volumeGradient)
  , m_Grid(volumeGradient.GetGrid())
  , m_Heat(heat)
  , m_Snapshots(snapshots)
  , m_Allocated(std::move(allocated))
{
  m_Fields.push_back(std::move(heat));
}

void
HeatEngineOnCpu::Finish()
{
  m_Heat = std::move(m_Fields[Heat]);
}

float *
HeatEngineOnCpu::Get(Field field, SliceStride stride)
{
  while (m_Fields.size() <= field)
  {
    m_Fields.emplace_back();
  }
  if (!m_Fields[field].GetData())
  {
    m_Fields[field] = PaddedField(m_Grid, stride > 1 ? PaddedField::Memory::OnDemand : PaddedField::Memory::Whole);
    m_Allocated();
  }
  return m_Fields[field].GetData();
}

unsigned int
HeatEngineOnCpu::GetLongestStretch(bool chebyshev) const
{
  return chebyshev ? chebyshevTile.steps : explicitTile.steps;
}

void
HeatEngineOnCpu::Copy(Field from, Field to)
{
  std::memcpy(this->Get(to), this->Get(from), m_Grid.GetLength() * sizeof(float));
}

void
HeatEngineOnCpu::Exchange(Field a, Field b)
{
  this->Get(a);
  this->Get(b);
  std::swap(m_Fields[a], m_Fields[b]);
}

void
HeatEngineOnCpu::Clear(Field field)
{
  std::memset(this->Get(field), 0, m_Grid.GetLength() * sizeof(float));
}

void
HeatEngineOnCpu::Scale(Field from, Field to, float factor, SliceStride stride)
{
  const float * const f = this->Get(from);
  float * const       out = this->Get(to, stride);
  ForAllRows(m_Grid, stride, [&](std::size_t, std::size_t row, unsigned int) {
    Kernels().Scale(out + row, f + row, m_Grid.GetSize()[0], factor);
  });
}

void
HeatEngineOnCpu::ClampToZero(Field field, SliceStride stride)
{
  float * const f = this->Get(field);
  ForAllRows(m_Grid, stride, [&](std::size_t, std::size_t row, unsigned int) {
    Kernels().ClampToZero(f + row, m_Grid.GetSize()[0]);
  });
}

void
HeatEngineOnCpu::StepExplicitly(unsigned int steps, float dt, bool compensated)
{
  const std::size_t nx = m_Grid.GetSize()[0];
  float * const     buffers[2] = { this->Get(Heat), this->Get(Even) };
  float * const     rest = compensated ? this->Get(Odd) : nullptr;
  RunTimeTiles(m_Grid, steps, explicitTile, [&](unsigned int step, std::size_t row) {
    const auto    edges = EdgesOfRow(m_VolumeGradient, row);
    const float * current = buffers[(step + 1) % 2] + row;
    float *       next = buffers[step % 2] + row;
    if (!compensated)
    {
      Kernels().ExplicitStep(edges, current, next, nx, dt);
      return;
    }
    Kernels().CompensatedStep(edges, current, next, rest + row, nx, dt);
  });
  if (steps % 2 == 1)
  {
    this->Exchange(Heat, Even);
  }
}

void
HeatEngineOnCpu::StepChebyshev(std::size_t        done,
                               unsigned int       steps,
                               float              scale,
                               const Expansions & coefficients,
                               SliceStride        stride)
{
  const std::size_t    nx = m_Grid.GetSize()[0];
  float * const        buffers[2] = { this->Get(Even), this->Get(Odd) };
  float * const        difference = this->Get(Difference);
  std::vector<float *> nodes(coefficients.size());
  for (std::size_t g = 0; g < nodes.size(); ++g)
  {
    nodes[g] = this->Get(FirstNode + static_cast<Field>(g));
  }
  RunTimeTiles(m_Grid, steps, chebyshevTile, [&](unsigned int s, std::size_t row) {
    const std::size_t   k = done + s;
    const float * const current = buffers[(k + 1) % 2] + row;
    float * const       next = buffers[k % 2] + row;
    Kernels().ChebyshevStep(
      EdgesOfRow(m_VolumeGradient, row), current, next, difference + row, nx, k == 1 ? 0.5F * scale : scale);
    ChebyshevPair pair{};
    const bool    inStride = stride == 1 || (row / m_Grid.GetStride(2) - 1) % stride == 0; // after a slice of padding
    for (std::size_t g = inStride ? 0 : nodes.size() - 1; k % 2 == 0 && g < nodes.size(); ++g)
    {
      if (FindPair(coefficients[g], k, pair))
      {
        Kernels().AddPair(nodes[g] + row, next, current, nx, pair.even, pair.odd);
      }
    }
  });
}

std::uint64_t
HeatEngineOnCpu::CountMoved(Field before, Field after, float change, float least)
{
  const std::size_t          nx = m_Grid.GetSize()[0];
  const std::size_t          ny = m_Grid.GetSize()[1];
  const float * const        f = this->Get(before);
  const float * const        g = this->Get(after);
  std::vector<std::uint64_t> moved(m_Grid.GetSize()[2], 0);
  ForAllRows(m_Grid, 1, [&](std::size_t row, std::size_t place, unsigned int) {
    for (std::size_t i = place; i < place + nx; ++i)
    {
      moved[row / ny] += DiffusionArithmetic::HasMoved(f, g, i, change, least) ? 1 : 0;
    }
  });
  return std::accumulate(moved.begin(), moved.end(), std::uint64_t{ 0 });
}

void
HeatEngineOnCpu::ShowRow(std::size_t   snapshot,
                         std::size_t   row,
                         const float * heat,
                         std::uint32_t weight,
                         unsigned int  worker)
{
  if (m_Snapshots.IsCounted(snapshot))
  {
    m_Snapshots.CountRow(snapshot, heat, weight, worker);
  }
  if (m_Snapshots.IsShown(snapshot))
  {
    m_Snapshots.ShowRow(snapshot, row, heat, worker);
  }
}

void
HeatEngineOnCpu::Show(std::size_t snapshot, Field field)
{
  const float * const f = this->Get(field);
  ForAllRows(m_Grid, 1, [&](std::size_t row, std::size_t place, unsigned int worker) {
    this->ShowRow(snapshot, row, f + place, 1, worker);
  });
}

void
HeatEngineOnCpu::ShowCombined(std::size_t                          first,
                              const std::array<Field, MostNodes> & nodes,
                              const std::vector<Weights> &         weights,
                              SliceStride                          stride)
{
  const std::size_t                    nx = m_Grid.GetSize()[0];
  std::array<const float *, MostNodes> fields{};
  std::transform(nodes.begin(), nodes.end(), fields.begin(), [this](Field node) { return this->Get(node); });
  std::vector<std::vector<float>> buffers(NumberOfThreads(), std::vector<float>(nx));
  ForAllRows(m_Grid, stride, [&](std::size_t row, std::size_t place, unsigned int worker) {
    const std::size_t                    following = m_Grid.GetSize()[2] - row / m_Grid.GetSize()[1];
    const auto                           weight = static_cast<std::uint32_t>(std::min(stride, following));
    std::array<const float *, MostNodes> rows{};
    std::transform(fields.begin(), fields.end(), rows.begin(), [place](const float * field) { return field + place; });
    for (std::size_t i = 0; i < weights.size(); ++i)
    {
      Kernels().Combine(buffers[worker].data(), rows.data(), nx, weights[i].data());
      this->ShowRow(first + i, row, buffers[worker].data(), weight, worker);
    }
  });
}
} // namespace shapeton
