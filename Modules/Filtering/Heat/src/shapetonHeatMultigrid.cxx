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
// Number of graphs with two visits to the next level per cycle. Measured on CT: with three instead of five, the run
// time grows by a tenth.
constexpr std::size_t firstTwice = 1;
constexpr std::size_t endTwice = 6;
constexpr unsigned    mostIterations = 1000;

/** The values of all labels at a node, with elementwise arithmetic. Compilers do not vectorize over labels for
 * indirect indices. */
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

/** Calls body(first slice, end) in parallel for every `stride`-th slab of `thickness` slices, from the slab `first`
 * on. */
template <typename TBody>
void
ForEachSlab(std::size_t slices, std::size_t thickness, std::size_t first, std::size_t stride, const TBody & body)
{
  const std::size_t slabs = (slices + thickness - 1) / thickness;
  ParallelFor((slabs + stride - 1 - first) / stride, [&](std::size_t i) {
    const FlushToZero flushToZero;
    const std::size_t begin = (stride * i + first) * thickness;
    body(begin, std::min(slices, begin + thickness));
  });
}

/** Calls body(first slice, end) for slabs of `thickness` slices: the even ones, then the odd ones; in reverse order
 * unless `forward`. Slabs of one half are not adjacent. */
template <typename TBody>
void
SweepSlabs(std::size_t slices, std::size_t thickness, bool forward, const TBody & body)
{
  for (std::size_t half = 0; half < 2; ++half)
  {
    ForEachSlab(slices, thickness, forward ? half : 1 - half, 2, body);
  }
}

/** Calls body(index of the row's first voxel) for the rows of a slice. */
template <typename TBody>
void
ForEachRowOfSlice(const PaddedGrid & grid, std::size_t slice, const TBody & body)
{
  for (std::size_t y = 0; y < grid.GetSize()[1]; ++y)
  {
    body(grid.GetRow(static_cast<std::ptrdiff_t>(y), static_cast<std::ptrdiff_t>(slice)));
  }
}

/** Calls body for all rows, in parallel over slices. */
template <typename TBody>
void
ForEachRow(const PaddedGrid & grid, const TBody & body)
{
  ParallelFor(grid.GetSize()[2], [&](std::size_t z) {
    const FlushToZero flushToZero;
    ForEachRowOfSlice(grid, z, body);
  });
}

// Slab thickness in slices for the sweeps over the finest level.
constexpr std::size_t slabOfField = 4;

/** Neighbors, in addition to west and south, that a forward sweep over the finest level updates before the voxels of a
 * slice. */
struct SweptBefore
{
  bool isBelow, isAbove;

  explicit SweptBefore(std::size_t slice)
  {
    const bool isOfSecondHalf = slice / slabOfField % 2 == 1;
    isBelow = isOfSecondHalf || slice % slabOfField != 0;
    isAbove = isOfSecondHalf && slice % slabOfField == slabOfField - 1;
  }
};

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

  /** 1 / (sum of the conductances and the leak); 0 if there are none, as for a seed. */
  float
  InverseDiagonal() const
  {
    const float diagonal = ((west + east) + (south + north)) + ((below + above) + leak);
    return diagonal > 0.0F ? 1.0F / diagonal : 0.0F;
  }

  /** The sum of the neighbor values of voxel i, weighted by their conductances. */
  template <int VLabels>
  Lanes<VLabels>
  Gather(const float * v, std::size_t i) const
  {
    return (west * Load<VLabels>(v, i - 1) + east * Load<VLabels>(v, i + 1)) +
           (south * Load<VLabels>(v, i - strideY) + north * Load<VLabels>(v, i + strideY)) +
           (below * Load<VLabels>(v, i - strideZ) + above * Load<VLabels>(v, i + strideZ));
  }

  /** The part of Gather() from neighbors that a forward sweep updates before voxel i. */
  template <int VLabels>
  Lanes<VLabels>
  GatherBefore(const float * v, std::size_t i, const SweptBefore & before) const
  {
    Lanes<VLabels> sum = west * Load<VLabels>(v, i - 1) + south * Load<VLabels>(v, i - strideY);
    if (before.isBelow)
    {
      sum += below * Load<VLabels>(v, i - strideZ);
    }
    if (before.isAbove)
    {
      sum += above * Load<VLabels>(v, i + strideZ);
    }
    return sum;
  }

  /** The remaining part of Gather(). */
  template <int VLabels>
  Lanes<VLabels>
  GatherAfter(const float * v, std::size_t i, const SweptBefore & before) const
  {
    Lanes<VLabels> sum = east * Load<VLabels>(v, i + 1) + north * Load<VLabels>(v, i + strideY);
    if (!before.isBelow)
    {
      sum += below * Load<VLabels>(v, i - strideZ);
    }
    if (!before.isAbove)
    {
      sum += above * Load<VLabels>(v, i + strideZ);
    }
    return sum;
  }

  /** Net outflow of voxel i, computed from differences to avoid cancellation. */
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

template <std::size_t VLabels>
std::array<double, VLabels>
SumOf(const std::vector<std::array<double, VLabels>> & parts)
{
  std::array<double, VLabels> sum{};
  for (const auto & part : parts)
  {
    for (std::size_t l = 0; l < VLabels; ++l)
    {
      sum[l] += part[l];
    }
  }
  return sum;
}

/** numerator / denominator for each label; 0 if the denominator is 0. */
template <std::size_t VLabels>
std::array<float, VLabels>
Ratio(const std::array<double, VLabels> & numerator, const std::array<double, VLabels> & denominator)
{
  std::array<float, VLabels> ratio{};
  for (std::size_t l = 0; l < VLabels; ++l)
  {
    ratio[l] = denominator[l] > 0.0 ? static_cast<float>(numerator[l] / denominator[l]) : 0.0F;
  }
  return ratio;
}
} // namespace

ConductanceHierarchy::ConductanceHierarchy(const VolumeGradientOperator & volumeGradient,
                                           const unsigned short *         seeds,
                                           const unsigned short *         before,
                                           const Progress &               progress)
  : m_Finest(volumeGradient, seeds, before), m_Aggregates(1)
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

LabelField::LabelField(std::size_t length) : m_Values(new float[length]), m_Length(length) { this->Clear(); }

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
HeatMultigrid<VLabels>::StepAndSweep(const Factors & step, float * residuals, float * corrections) const
{
  const ConductanceField & field = m_Hierarchy.GetFinest();
  const auto               steps = Load<VLabels>(step.data(), 0);
  SweepSlabs(field.grid.GetSize()[2], slabOfField, true, [&](std::size_t begin, std::size_t end) {
    for (std::size_t z = begin; z < end; ++z)
    {
      const SweptBefore before(z);
      ForEachRowOfSlice(field.grid, z, [&](std::size_t row) {
        for (std::size_t i = row; i < row + field.grid.GetSize()[0]; ++i)
        {
          const Lanes<VLabels> residual = Load<VLabels>(residuals, i) - steps * Load<VLabels>(corrections, i);
          const Star           star(field, i);
          Store<VLabels>(residuals, i, residual);
          Store<VLabels>(corrections,
                         i,
                         star.InverseDiagonal() *
                           (residual + star.template GatherBefore<VLabels>(corrections, i, before)));
        }
      });
    }
  });
}

template <int VLabels>
typename HeatMultigrid<VLabels>::Measure
HeatMultigrid<VLabels>::SweepBack(const float * residuals, float * corrections) const
{
  const ConductanceField & field = m_Hierarchy.GetFinest();
  const auto               size = field.grid.GetSize();
  std::vector<Sums>        products(size[2]);
  std::vector<float>       greatest(size[2], 0.0F);
  SweepSlabs(size[2], slabOfField, false, [&](std::size_t begin, std::size_t end) {
    for (std::size_t z = end; z-- > begin;)
    {
      DoubleLanes<VLabels> sums{};
      for (std::size_t y = size[1]; y-- > 0;)
      {
        const std::size_t row = field.grid.GetRow(static_cast<std::ptrdiff_t>(y), static_cast<std::ptrdiff_t>(z));
        for (std::size_t i = row + size[0]; i-- > row;)
        {
          const Lanes<VLabels> residual = Load<VLabels>(residuals, i);
          const Star           star(field, i);
          const Lanes<VLabels> value =
            star.InverseDiagonal() * (residual + star.template Gather<VLabels>(corrections, i));
          Store<VLabels>(corrections, i, value);
          AddProducts<VLabels>(sums, value, residual);
        }
        greatest[z] = GreatestMagnitude(corrections + row * VLabels, size[0] * VLabels, greatest[z]);
      }
      std::memcpy(products[z].data(), &sums, sizeof(sums));
    }
  });
  return { SumOf(products), *std::max_element(greatest.begin(), greatest.end()) };
}

template <int VLabels>
void
HeatMultigrid<VLabels>::SweepGraph(std::size_t level, bool forward)
{
  constexpr std::size_t    slab = 2;
  const ConductanceGraph & graph = m_Hierarchy.GetGraphs()[level];
  const float * const      residuals = m_Residuals[level].GetData();
  float * const            values = m_Values[level].GetData();
  SweepSlabs(graph.cells[2], slab, forward, [&](std::size_t begin, std::size_t end) {
    const std::uint64_t first = graph.firstOfSlice[begin];
    const std::uint64_t last = graph.firstOfSlice[end];
    for (std::uint64_t n = first; n < last; ++n)
    {
      const std::uint64_t i = forward ? n : first + last - 1 - n;
      Lanes<VLabels>      sum = Load<VLabels>(residuals, i);
      graph.ForEachEdge(
        i, [&](std::size_t neighbor, float conductance) { sum += conductance * Load<VLabels>(values, neighbor); });
      Store<VLabels>(values, i, graph.inverse[i] * sum);
    }
  });
}

/** After a forward sweep from 0 the residual of a voxel depends only on its later neighbors. */
template <int VLabels>
void
HeatMultigrid<VLabels>::RestrictFromField(const float * values)
{
  const ConductanceField & field = m_Hierarchy.GetFinest();
  const auto &             aggregateOf = m_Hierarchy.GetAggregates()[0];
  const std::size_t        slices = field.grid.GetSize()[2];
  const std::size_t        coarseSlices = m_Hierarchy.GetGraphs()[0].cells[2];
  const std::size_t        step = coarseSlices == slices ? 1 : 2;
  float * const            target = m_Residuals[0].GetData();
  m_Residuals[0].Clear();
  ParallelFor(coarseSlices, [&](std::size_t coarse) {
    const FlushToZero flushToZero;
    for (std::size_t z = coarse * step; z < std::min(slices, (coarse + 1) * step); ++z)
    {
      const SweptBefore before(z);
      ForEachRowOfSlice(field.grid, z, [&](std::size_t row) {
        for (std::size_t i = row; i < row + field.grid.GetSize()[0]; ++i)
        {
          if (aggregateOf[i] != noAggregate)
          {
            const Lanes<VLabels> rest = Star(field, i).template GatherAfter<VLabels>(values, i, before);
            Store<VLabels>(target, aggregateOf[i], Load<VLabels>(target, aggregateOf[i]) + rest);
          }
        }
      });
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
      graph.ForEachEdge(i, [&](std::size_t neighbor, float conductance) {
        rest -= conductance * (value - Load<VLabels>(values, neighbor));
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
  ForEachRow(grid, [&](std::size_t row) {
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

/** Computes the correction of a graph from its residuals. Pre- and post-smoothing are mirrored, so the cycle is
 * symmetric, as conjugate gradients require. */
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
typename HeatMultigrid<VLabels>::Measure
HeatMultigrid<VLabels>::Precondition(const Factors & step, float * residuals, float * corrections)
{
  this->StepAndSweep(step, residuals, corrections);
  this->RestrictFromField(corrections);
  this->CycleGraph(0);
  this->ProlongToField(corrections);
  return this->SweepBack(residuals, corrections);
}

template <int VLabels>
void
HeatMultigrid<VLabels>::SubtractImage(const LabelField & potentials, LabelField & residuals) const
{
  const ConductanceField & field = m_Hierarchy.GetFinest();
  ForEachRow(field.grid, [&](std::size_t row) {
    for (std::size_t i = row; i < row + field.grid.GetSize()[0]; ++i)
    {
      const Lanes<VLabels> flow = Star(field, i).template Outflow<VLabels>(potentials.GetData(), i);
      Store<VLabels>(residuals.GetData(), i, Load<VLabels>(residuals.GetData(), i) - flow);
    }
  });
}

template <int VLabels>
typename HeatMultigrid<VLabels>::Sums
HeatMultigrid<VLabels>::Advance(const Factors & step,
                                const Factors & share,
                                float *         potentials,
                                float *         directions,
                                float *         corrections) const
{
  constexpr std::size_t    thickness = 16;
  const ConductanceField & field = m_Hierarchy.GetFinest();
  const std::size_t        nx = field.grid.GetSize()[0];
  const std::size_t        slices = field.grid.GetSize()[2];
  const auto               steps = Load<VLabels>(step.data(), 0);
  const auto               shares = Load<VLabels>(share.data(), 0);
  const auto               turn = [&](std::size_t z) {
    ForEachRowOfSlice(field.grid, z, [&](std::size_t row) {
      for (std::size_t i = row; i < row + nx; ++i)
      {
        const Lanes<VLabels> direction = Load<VLabels>(directions, i);
        Store<VLabels>(potentials, i, Load<VLabels>(potentials, i) + steps * direction);
        Store<VLabels>(directions, i, Load<VLabels>(corrections, i) + shares * direction);
      }
    });
  };
  std::vector<Sums> energies(slices);
  const auto        apply = [&](std::size_t z) {
    DoubleLanes<VLabels> sums{};
    ForEachRowOfSlice(field.grid, z, [&](std::size_t row) {
      for (std::size_t i = row; i < row + nx; ++i)
      {
        const Lanes<VLabels> flow = Star(field, i).template Outflow<VLabels>(directions, i);
        Store<VLabels>(corrections, i, flow);
        AddProducts<VLabels>(sums, flow, Load<VLabels>(directions, i));
      }
    });
    std::memcpy(energies[z].data(), &sums, sizeof(sums));
  };
  // Directions at slab boundaries are updated first; each slab then requires a single pass through memory.
  ForEachSlab(slices, thickness, 0, 1, [&](std::size_t begin, std::size_t end) {
    turn(begin);
    if (begin + 1 < end)
    {
      turn(end - 1);
    }
  });
  ForEachSlab(slices, thickness, 0, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t z = begin; z < end; ++z)
    {
      if (z + 2 < end)
      {
        turn(z + 1);
      }
      apply(z);
    }
  });
  return SumOf(energies);
}

template <int VLabels>
unsigned int
HeatMultigrid<VLabels>::Solve(LabelField &     potentials,
                              LabelField &     residuals,
                              double           tolerance,
                              const Progress & progress)
{
  LabelField   directions(residuals.GetLength());
  LabelField   corrections(residuals.GetLength());
  Sums         before{};
  Factors      step{}; // along the directions; potentials and residuals apply it in the next pass
  double       firstChange = 0.0;
  double       share = 0.0; // changes may increase occasionally; the reported progress must not
  unsigned int iteration = 0;
  for (; iteration < mostIterations; ++iteration)
  {
    const Measure now = this->Precondition(step, residuals.GetData(), corrections.GetData());
    firstChange = iteration == 0 ? now.greatest : firstChange;
    if (now.greatest <= tolerance)
    {
      break;
    }
    share = std::clamp(std::log(firstChange / now.greatest) / std::log(firstChange / tolerance), share, 1.0);
    progress(share);
    const Sums energy = this->Advance(
      step, Ratio(now.products, before), potentials.GetData(), directions.GetData(), corrections.GetData());
    before = now.products;
    step = Ratio(now.products, energy);
  }
  const auto steps = Load<VLabels>(step.data(), 0);
  ForEachRow(m_Hierarchy.GetFinest().grid, [&](std::size_t row) {
    for (std::size_t i = row; i < row + m_Hierarchy.GetFinest().grid.GetSize()[0]; ++i)
    {
      Store<VLabels>(potentials.GetData(),
                     i,
                     Load<VLabels>(potentials.GetData(), i) + steps * Load<VLabels>(directions.GetData(), i));
    }
  });
  progress(1.0);
  return iteration;
}

template class HeatMultigrid<1>;
template class HeatMultigrid<2>;
template class HeatMultigrid<4>;
} // namespace shapeton
