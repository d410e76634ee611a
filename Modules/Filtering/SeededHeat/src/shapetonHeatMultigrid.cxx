#include "shapetonHeatMultigrid.h"

#include "shapetonFlushToZero.h"
#include "shapetonParallelFor.h"

#include <cmath>
#include <cstring>

namespace shapeton
{
namespace
{
constexpr std::size_t coarsestNodes = 200;
constexpr std::size_t mostLevels = 16;
constexpr int         sweepsOnCoarsest = 10;
// Graphs whose next level is visited twice in a cycle: measured on CT, where with three of them in place of five the
// whole takes a tenth longer.
constexpr std::size_t firstTwice = 1;
constexpr std::size_t endTwice = 6;
constexpr unsigned    mostIterations = 1000;

/** The values of all labels at a place: arithmetic acts on each of them. The compiler does not find these vectors where
 * the places come from a list. */
template <int VLabels>
struct LaneTypes;
template <>
struct LaneTypes<1>
{
  using Floats = float;
  using Doubles = double;
};
template <>
struct LaneTypes<2>
{
  using Floats = float __attribute__((vector_size(8)));
  using Doubles = double __attribute__((vector_size(16)));
};
template <>
struct LaneTypes<4>
{
  using Floats = float __attribute__((vector_size(16)));
  using Doubles = double __attribute__((vector_size(32)));
};
template <int VLabels>
using Lanes = typename LaneTypes<VLabels>::Floats;
template <int VLabels>
using DoubleLanes = typename LaneTypes<VLabels>::Doubles;

template <int VLabels>
Lanes<VLabels>
Load(const float * values, std::size_t place)
{
  Lanes<VLabels> lanes;
  std::memcpy(&lanes, values + place * VLabels, sizeof(lanes));
  return lanes;
}

template <int VLabels>
void
Store(float * values, std::size_t place, const Lanes<VLabels> & lanes)
{
  std::memcpy(values + place * VLabels, &lanes, sizeof(lanes));
}

/** sums += a b, in double precision. */
template <int VLabels>
void
AddProducts(DoubleLanes<VLabels> & sums, const Lanes<VLabels> & a, const Lanes<VLabels> & b)
{
  if constexpr (VLabels == 1)
  {
    sums += double{ a } * double{ b };
  }
  else
  {
    using Doubles = DoubleLanes<VLabels>;
    sums += __builtin_convertvector(a, Doubles) * __builtin_convertvector(b, Doubles);
  }
}

/** Calls body(first slice, end) for slabs of `thickness` slices, every other one at first, then the rest; the other way
 * round unless `forward`. Slabs of one half do not touch each other. */
template <typename TBody>
void
ForEachSlab(std::size_t slices, std::size_t thickness, bool forward, const TBody & body)
{
  const std::size_t slabs = (slices + thickness - 1) / thickness;
  for (std::size_t half = 0; half < 2; ++half)
  {
    const std::size_t first = forward ? half : 1 - half;
    ParallelFor((slabs + 1 - first) / 2, [&](std::size_t i) {
      const FlushToZero flushToZero;
      const std::size_t begin = (2 * i + first) * thickness;
      body(begin, std::min(slices, begin + thickness));
    });
  }
}

/** Calls body(place of the row's first voxel, slice) for all rows, in parallel over slices. */
template <typename TBody>
void
ForEachRow(const PaddedGrid & grid, const TBody & body)
{
  ParallelFor(grid.GetSize()[2], [&](std::size_t z) {
    const FlushToZero flushToZero;
    for (std::size_t y = 0; y < grid.GetSize()[1]; ++y)
    {
      body(grid.GetRow(static_cast<std::ptrdiff_t>(y), static_cast<std::ptrdiff_t>(z)), z);
    }
  });
}

/** The six edges of a voxel, and its leak. */
struct Star
{
  float       west, east, south, north, below, above, leak;
  std::size_t strideY, strideZ;

  Star(const ConductanceField & field, std::size_t i)
    : west(field.conductances[0].GetData()[i - 1])
    , east(field.conductances[0].GetData()[i])
    , south(field.conductances[1].GetData()[i - field.grid.GetStride(1)])
    , north(field.conductances[1].GetData()[i])
    , below(field.conductances[2].GetData()[i - field.grid.GetStride(2)])
    , above(field.conductances[2].GetData()[i])
    , leak(field.leak.GetData()[i])
    , strideY(field.grid.GetStride(1))
    , strideZ(field.grid.GetStride(2))
  {}

  float
  Diagonal() const
  {
    return ((west + east) + (south + north)) + ((below + above) + leak);
  }

  /** The sum of the values of the neighbours of voxel i, times their conductances. */
  template <int VLabels>
  Lanes<VLabels>
  Gather(const float * v, std::size_t i) const
  {
    return (west * Load<VLabels>(v, i - 1) + east * Load<VLabels>(v, i + 1)) +
           (south * Load<VLabels>(v, i - strideY) + north * Load<VLabels>(v, i + strideY)) +
           (below * Load<VLabels>(v, i - strideZ) + above * Load<VLabels>(v, i + strideZ));
  }

  /** What flows out of voxel i: in differences, which lose no digits where values are alike. */
  template <int VLabels>
  Lanes<VLabels>
  Outflow(const float * v, std::size_t i) const
  {
    const Lanes<VLabels> value = Load<VLabels>(v, i);
    return ((west * (value - Load<VLabels>(v, i - 1)) + east * (value - Load<VLabels>(v, i + 1))) +
            (south * (value - Load<VLabels>(v, i - strideY)) + north * (value - Load<VLabels>(v, i + strideY)))) +
           ((below * (value - Load<VLabels>(v, i - strideZ)) + above * (value - Load<VLabels>(v, i + strideZ))) +
            leak * value);
  }
};

float
GreatestMagnitude(const float * values, std::size_t number, float greatest)
{
  for (std::size_t i = 0; i < number; ++i)
  {
    greatest = std::max(greatest, std::abs(values[i]));
  }
  return greatest;
}

template <typename TSums>
TSums
SumOf(const std::vector<TSums> & parts)
{
  TSums sum{};
  for (const TSums & part : parts)
  {
    for (std::size_t l = 0; l < sum.size(); ++l)
    {
      sum[l] += part[l];
    }
  }
  return sum;
}

/** numerator / denominator of each label; 0 where the denominator is. */
template <typename TSums>
TSums
Ratio(const TSums & numerator, const TSums & denominator)
{
  TSums ratio{};
  for (std::size_t l = 0; l < ratio.size(); ++l)
  {
    ratio[l] = denominator[l] > 0.0 ? numerator[l] / denominator[l] : 0.0;
  }
  return ratio;
}
} // namespace

ConductanceHierarchy::ConductanceHierarchy(const VolumeGradientOperator & volumeGradient,
                                           const unsigned short *         seeds,
                                           const Progress &               progress)
  : m_Finest(volumeGradient, seeds), m_Aggregates(1)
{
  progress(0.3);
  m_Graphs.push_back(Coarsen(m_Finest, m_Aggregates[0]));
  while (m_Graphs.back().GetNumberOfNodes() > coarsestNodes && m_Graphs.size() < mostLevels)
  {
    progress(0.8);
    m_Aggregates.emplace_back();
    ConductanceGraph next = Coarsen(m_Graphs.back(), m_Aggregates.back());
    m_Graphs.push_back(std::move(next));
  }
}

void
LabelField::Clear()
{
  constexpr std::size_t block = 65536;
  ParallelFor((m_Length + block - 1) / block, [&](std::size_t i) {
    std::memset(m_Values.get() + i * block, 0, std::min(block, m_Length - i * block) * sizeof(float));
  });
}

template <int VLabels>
HeatMultigrid<VLabels>::HeatMultigrid(const ConductanceHierarchy & hierarchy) : m_Hierarchy(hierarchy)
{
  for (const ConductanceGraph & graph : hierarchy.GetGraphs())
  {
    m_Residuals.emplace_back(graph.GetNumberOfNodes() * VLabels);
    m_Values.emplace_back(graph.GetNumberOfNodes() * VLabels);
  }
}

template <int VLabels>
void
HeatMultigrid<VLabels>::SweepField(const float * residuals, float * values, bool forward) const
{
  constexpr std::size_t    slab = 4;
  const ConductanceField & field = m_Hierarchy.GetFinest();
  const auto               size = field.grid.GetSize();
  ForEachSlab(size[2], slab, forward, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = 0; n < (end - begin) * size[1]; ++n)
    {
      const std::size_t row = forward ? n : (end - begin) * size[1] - 1 - n;
      const std::size_t first = field.grid.GetRow(static_cast<std::ptrdiff_t>(row % size[1]),
                                                  static_cast<std::ptrdiff_t>(begin + row / size[1]));
      for (std::size_t x = 0; x < size[0]; ++x)
      {
        const std::size_t i = first + (forward ? x : size[0] - 1 - x);
        const Star        star(field, i);
        const float       diagonal = star.Diagonal();
        const float       inverse = diagonal > 0.0F ? 1.0F / diagonal : 0.0F;
        Store<VLabels>(values, i, inverse * (Load<VLabels>(residuals, i) + star.template Gather<VLabels>(values, i)));
      }
    }
  });
}

template <int VLabels>
void
HeatMultigrid<VLabels>::SweepGraph(std::size_t level, bool forward)
{
  constexpr std::size_t    slab = 2;
  const ConductanceGraph & graph = m_Hierarchy.GetGraphs()[level];
  const float * const      residuals = m_Residuals[level].GetData();
  float * const            values = m_Values[level].GetData();
  ForEachSlab(graph.cells[2], slab, forward, [&](std::size_t begin, std::size_t end) {
    const std::uint64_t first = graph.firstOfSlice[begin];
    const std::uint64_t last = graph.firstOfSlice[end];
    for (std::uint64_t n = first; n < last; ++n)
    {
      const std::uint64_t i = forward ? n : first + last - 1 - n;
      Lanes<VLabels>      sum = Load<VLabels>(residuals, i);
      graph.ForEachEdge(
        i, [&](std::size_t neighbour, float conductance) { sum += conductance * Load<VLabels>(values, neighbour); });
      Store<VLabels>(values, i, graph.inverse[i] * sum);
    }
  });
}

template <int VLabels>
void
HeatMultigrid<VLabels>::RestrictFromField(const float * residuals, const float * values)
{
  const ConductanceField & field = m_Hierarchy.GetFinest();
  const auto &             aggregateOf = m_Hierarchy.GetAggregates()[0];
  const std::size_t        slices = field.grid.GetSize()[2];
  const std::size_t        coarseSlices = m_Hierarchy.GetGraphs()[0].cells[2];
  const std::size_t        step = coarseSlices == slices ? 1 : 2;
  float * const            target = m_Residuals[0].GetData();
  m_Residuals[0].Clear();
  ParallelFor(coarseSlices, [&](std::size_t slice) {
    const FlushToZero flushToZero;
    for (std::size_t row = slice * step * field.grid.GetSize()[1];
         row < std::min(slices, (slice + 1) * step) * field.grid.GetSize()[1];
         ++row)
    {
      const std::size_t first = field.grid.GetRow(static_cast<std::ptrdiff_t>(row % field.grid.GetSize()[1]),
                                                  static_cast<std::ptrdiff_t>(row / field.grid.GetSize()[1]));
      for (std::size_t i = first; i < first + field.grid.GetSize()[0]; ++i)
      {
        if (aggregateOf[i] == noAggregate)
        {
          continue;
        }
        const Lanes<VLabels> rest = Load<VLabels>(residuals, i) - Star(field, i).template Outflow<VLabels>(values, i);
        Store<VLabels>(target, aggregateOf[i], Load<VLabels>(target, aggregateOf[i]) + rest);
      }
    }
  });
}

template <int VLabels>
void
HeatMultigrid<VLabels>::RestrictFromGraph(std::size_t level)
{
  const ConductanceGraph & graph = m_Hierarchy.GetGraphs()[level];
  const auto &             aggregateOf = m_Hierarchy.GetAggregates()[level + 1];
  const std::size_t        coarseSlices = m_Hierarchy.GetGraphs()[level + 1].cells[2];
  const std::size_t        step = coarseSlices == graph.cells[2] ? 1 : 2;
  const float * const      residuals = m_Residuals[level].GetData();
  const float * const      values = m_Values[level].GetData();
  float * const            target = m_Residuals[level + 1].GetData();
  m_Residuals[level + 1].Clear();
  ParallelFor(coarseSlices, [&](std::size_t slice) {
    const FlushToZero flushToZero;
    const auto        places = graph.GetPlacesOfSlices(slice * step, std::min(graph.cells[2], (slice + 1) * step));
    for (std::size_t i = places[0]; i < places[1]; ++i)
    {
      const Lanes<VLabels> value = Load<VLabels>(values, i);
      Lanes<VLabels>       rest = Load<VLabels>(residuals, i) - graph.leak[i] * value;
      graph.ForEachEdge(i, [&](std::size_t neighbour, float conductance) {
        rest -= conductance * (value - Load<VLabels>(values, neighbour));
      });
      Store<VLabels>(target, aggregateOf[i], Load<VLabels>(target, aggregateOf[i]) + rest);
    }
  });
}

template <int VLabels>
void
HeatMultigrid<VLabels>::ProlongToField(float * values) const
{
  const PaddedGrid &  grid = m_Hierarchy.GetFinest().grid;
  const auto &        aggregateOf = m_Hierarchy.GetAggregates()[0];
  const float * const source = m_Values[0].GetData();
  ForEachRow(grid, [&](std::size_t row, std::size_t) {
    for (std::size_t i = row; i < row + grid.GetSize()[0]; ++i)
    {
      if (aggregateOf[i] != noAggregate)
      {
        Store<VLabels>(values, i, Load<VLabels>(values, i) + Load<VLabels>(source, aggregateOf[i]));
      }
    }
  });
}

template <int VLabels>
void
HeatMultigrid<VLabels>::ProlongToGraph(std::size_t level)
{
  const auto &        aggregateOf = m_Hierarchy.GetAggregates()[level + 1];
  const float * const source = m_Values[level + 1].GetData();
  float * const       values = m_Values[level].GetData();
  ParallelForBlocks(aggregateOf.size(), [&](std::size_t i) {
    Store<VLabels>(values, i, Load<VLabels>(values, i) + Load<VLabels>(source, aggregateOf[i]));
  });
}

/** From the residuals of a graph to its values. The sweeps before and after are mirror images, so the whole is
 * symmetric, as conjugate gradients need it. */
template <int VLabels>
void
HeatMultigrid<VLabels>::CycleGraph(std::size_t level)
{
  m_Values[level].Clear();
  if (level + 1 == m_Residuals.size())
  {
    for (int sweep = 0; sweep < sweepsOnCoarsest; ++sweep)
    {
      this->SweepGraph(level, true);
      this->SweepGraph(level, false);
    }
    return;
  }
  for (int visit = 0; visit < (level >= firstTwice && level < endTwice ? 2 : 1); ++visit)
  {
    this->SweepGraph(level, true);
    this->RestrictFromGraph(level);
    this->CycleGraph(level + 1);
    this->ProlongToGraph(level);
    this->SweepGraph(level, false);
  }
}

template <int VLabels>
void
HeatMultigrid<VLabels>::Precondition(const LabelField & residuals, LabelField & corrections)
{
  corrections.Clear();
  this->SweepField(residuals.GetData(), corrections.GetData(), true);
  this->RestrictFromField(residuals.GetData(), corrections.GetData());
  this->CycleGraph(0);
  this->ProlongToField(corrections.GetData());
  this->SweepField(residuals.GetData(), corrections.GetData(), false);
}

template <int VLabels>
void
HeatMultigrid<VLabels>::SubtractImage(const LabelField & potentials, LabelField & residuals) const
{
  const ConductanceField & field = m_Hierarchy.GetFinest();
  ForEachRow(field.grid, [&](std::size_t row, std::size_t) {
    for (std::size_t i = row; i < row + field.grid.GetSize()[0]; ++i)
    {
      const Lanes<VLabels> flow = Star(field, i).template Outflow<VLabels>(potentials.GetData(), i);
      Store<VLabels>(residuals.GetData(), i, Load<VLabels>(residuals.GetData(), i) - flow);
    }
  });
}

template <int VLabels>
unsigned int
HeatMultigrid<VLabels>::Solve(LabelField &     potentials,
                              LabelField &     residuals,
                              double           tolerance,
                              const Progress & progress)
{
  const ConductanceField & field = m_Hierarchy.GetFinest();
  const std::size_t        nx = field.grid.GetSize()[0];
  const std::size_t        slices = field.grid.GetSize()[2];
  LabelField               directions(residuals.GetLength());
  LabelField               corrections(residuals.GetLength());
  float * const            x = potentials.GetData();
  float * const            r = residuals.GetData();
  float * const            p = directions.GetData();
  float * const            z = corrections.GetData();
  Sums                     before{};
  double                   firstChange = 0.0;
  double                   share = 0.0; // changes may grow now and then, what is reported does not
  for (unsigned int iteration = 0; iteration < mostIterations; ++iteration)
  {
    this->Precondition(residuals, corrections);
    std::vector<Sums>  products(slices, Sums{});
    std::vector<float> changes(slices, 0.0F);
    ForEachRow(field.grid, [&](std::size_t row, std::size_t slice) {
      DoubleLanes<VLabels> sums;
      std::memcpy(&sums, products[slice].data(), sizeof(sums));
      for (std::size_t i = row; i < row + nx; ++i)
      {
        AddProducts<VLabels>(sums, Load<VLabels>(z, i), Load<VLabels>(r, i));
      }
      std::memcpy(products[slice].data(), &sums, sizeof(sums));
      changes[slice] = GreatestMagnitude(z + row * VLabels, nx * VLabels, changes[slice]);
    });
    const double change = *std::max_element(changes.begin(), changes.end());
    firstChange = iteration == 0 ? change : firstChange;
    if (change <= tolerance)
    {
      progress(1.0);
      return iteration;
    }
    share = std::clamp(std::log(firstChange / change) / std::log(firstChange / tolerance), share, 1.0);
    progress(share);
    const Sums product = SumOf(products);
    const Sums beta = Ratio(product, before);
    before = product;
    ForEachRow(field.grid, [&](std::size_t row, std::size_t) {
      for (std::size_t i = row * VLabels; i < (row + nx) * VLabels; i += VLabels)
      {
        for (int l = 0; l < VLabels; ++l)
        {
          p[i + l] = z[i + l] + static_cast<float>(beta[l]) * p[i + l];
        }
      }
    });
    std::vector<Sums> energies(slices, Sums{});
    ForEachRow(field.grid, [&](std::size_t row, std::size_t slice) {
      DoubleLanes<VLabels> sums;
      std::memcpy(&sums, energies[slice].data(), sizeof(sums));
      for (std::size_t i = row; i < row + nx; ++i)
      {
        const Lanes<VLabels> flow = Star(field, i).template Outflow<VLabels>(p, i);
        Store<VLabels>(z, i, flow);
        AddProducts<VLabels>(sums, flow, Load<VLabels>(p, i));
      }
      std::memcpy(energies[slice].data(), &sums, sizeof(sums));
    });
    const Sums alpha = Ratio(product, SumOf(energies));
    ForEachRow(field.grid, [&](std::size_t row, std::size_t) {
      for (std::size_t i = row * VLabels; i < (row + nx) * VLabels; i += VLabels)
      {
        for (int l = 0; l < VLabels; ++l)
        {
          x[i + l] += static_cast<float>(alpha[l]) * p[i + l];
          r[i + l] -= static_cast<float>(alpha[l]) * z[i + l];
        }
      }
    });
  }
  return mostIterations;
}

template class HeatMultigrid<1>;
template class HeatMultigrid<2>;
template class HeatMultigrid<4>;
} // namespace shapeton
