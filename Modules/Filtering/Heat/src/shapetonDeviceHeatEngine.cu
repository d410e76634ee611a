// Contains only kernel launches; the arithmetic is shared with the CPU.
#include "shapetonDeviceHeatEngine.h"
#include "shapetonDeviceRuntime.h"
#include "shapetonDiffusionArithmetic.h"

namespace shapeton
{
namespace
{
using DeviceRuntime::Memory;

/** Memory indices of a field's voxels. */
struct Places
{
  std::size_t first;
  std::size_t strideY;
  std::size_t strideZ;

  SHAPETON_HOST_DEVICE std::size_t
                       operator()(std::size_t x, std::size_t y, std::size_t z) const
  {
    return first + z * strideZ + y * strideY + x;
  }
};

struct Explicit
{
  Places         at;
  DiffusionEdges edges;
  const float *  f;
  float *        out;
  float          dt;

  SHAPETON_HOST_DEVICE void
  operator()(std::size_t x, std::size_t y, std::size_t z) const
  {
    DiffusionArithmetic::ExplicitStep(edges, f, out, at(x, y, z), dt);
  }
};

struct Compensated
{
  Places         at;
  DiffusionEdges edges;
  const float *  f;
  float *        out;
  float *        rest;
  float          dt;

  SHAPETON_HOST_DEVICE void
  operator()(std::size_t x, std::size_t y, std::size_t z) const
  {
    DiffusionArithmetic::CompensatedStep(edges, f, out, rest, at(x, y, z), dt);
  }
};

/** Two steps of the recurrence, from T_k with even k to the next even one, and their contributions to the nodes while
 * the values are in registers. Results have separate memory because neighbors still need the old values. */
struct TwoChebyshevSteps
{
  using Neighborhood = DiffusionArithmetic::Neighborhood;

  Places         at;
  DiffusionEdges edges;
  const float *  f;
  const float *  difference;
  float *        out;
  float *        nextDifference;
  float          firstScale;
  float          scale;
  unsigned int   pairs;
  float *        nodes[HeatEngine::MostNodes];
  ChebyshevPair  terms[HeatEngine::MostNodes];

  /** T_k of odd k; `kept` is its difference. */
  SHAPETON_HOST_DEVICE float
  First(std::size_t x, std::size_t y, std::size_t z, float & kept) const
  {
    const std::size_t i = at(x, y, z);
    kept = DiffusionArithmetic::NextDifference(difference[i], firstScale, DiffusionArithmetic::Flow(edges, f, i));
    return f[i] + kept;
  }

  SHAPETON_HOST_DEVICE void
  Second(std::size_t x, std::size_t y, std::size_t z, const Neighborhood & odd, float kept) const
  {
    const std::size_t i = at(x, y, z);
    float             sums[HeatEngine::MostNodes]; // loaded together to hide the memory latency
    for (unsigned int g = 0; g < HeatEngine::MostNodes; ++g)
    {
      sums[g] = g < pairs ? nodes[g][i] : 0.0F;
    }
    const float next = DiffusionArithmetic::NextDifference(kept, scale, DiffusionArithmetic::Flow(edges, odd, i));
    const float even = odd.center + next;
    nextDifference[i] = next;
    out[i] = even;
    for (unsigned int g = 0; g < HeatEngine::MostNodes; ++g)
    {
      if (g < pairs)
      {
        nodes[g][i] = DiffusionArithmetic::WithPair(sums[g], even, odd.center, terms[g].even, terms[g].odd);
      }
    }
  }
};

struct Scaled
{
  Places        at;
  const float * f;
  float *       out;
  float         factor;

  SHAPETON_HOST_DEVICE void
  operator()(std::size_t x, std::size_t y, std::size_t z) const
  {
    const std::size_t i = at(x, y, z);
    out[i] = factor * f[i];
  }
};

struct Clamped
{
  Places  at;
  float * f;

  SHAPETON_HOST_DEVICE void
  operator()(std::size_t x, std::size_t y, std::size_t z) const
  {
    const std::size_t i = at(x, y, z);
    f[i] = DiffusionArithmetic::ClampedToZero(f[i]);
  }
};

/** Converts the number of a voxel in every n-th slice to its memory index. */
struct Numbered
{
  Places      at;
  std::size_t nx;
  std::size_t ny;
  std::size_t stride{ 1 };
  std::size_t firstSlice{ 0 };

  SHAPETON_HOST_DEVICE std::size_t
                       operator()(std::size_t number) const
  {
    const std::size_t row = number / nx;
    return at(number - row * nx, row % ny, firstSlice + row / ny * stride);
  }
};

struct Sum
{
  std::uint64_t number{ 0 };

  SHAPETON_HOST_DEVICE void
  Add(const Sum & other)
  {
    number += other.number;
  }
};

struct Moved
{
  Numbered      at;
  const float * before;
  const float * after;
  float         change;
  float         least;

  SHAPETON_HOST_DEVICE void
  operator()(std::size_t number, Sum & sum) const
  {
    sum.number += DiffusionArithmetic::HasMoved(before, after, at(number), change, least) ? 1 : 0;
  }
};

/** The heat of snapshots, interpolated between the fields at the nodes. */
struct Combination
{
  const float *       nodes[HeatEngine::MostNodes];
  HeatEngine::Weights weights[2];

  SHAPETON_HOST_DEVICE float
  operator()(std::size_t i, unsigned int row) const
  {
    return DiffusionArithmetic::Combined(nodes, i, &weights[row][0]);
  }
};

struct CombinedField
{
  Places      at;
  Combination combination;
  float *     out;

  SHAPETON_HOST_DEVICE void
  operator()(std::size_t x, std::size_t y, std::size_t z) const
  {
    const std::size_t i = at(x, y, z);
    out[i] = combination(i, 0);
  }
};

struct BinOfField
{
  Numbered      at;
  const float * f;

  SHAPETON_HOST_DEVICE unsigned int
  operator()(std::size_t number, unsigned int) const
  {
    return DiffusionArithmetic::BinOf(f[at(number)]);
  }
};

struct BinOfCombination
{
  Numbered    at;
  Combination combination;

  SHAPETON_HOST_DEVICE unsigned int
  operator()(std::size_t number, unsigned int row) const
  {
    return DiffusionArithmetic::BinOf(combination(at(number), row));
  }
};

class Engine : public DeviceHeatEngine
{
public:
  Engine(const DeviceHeatVolume & volume, float * heat, HeatSnapshots * snapshots)
    : m_Grid(volume.grid)
    , m_Heat(heat)
    , m_Snapshots(snapshots)
    , m_Extent{ m_Grid.GetSize()[0], m_Grid.GetSize()[1], m_Grid.GetSize()[2] }
    , m_Places{ m_Grid.GetRow(0, 0), m_Grid.GetStride(1), m_Grid.GetStride(2) }
    , m_Numbered{ m_Places, m_Extent.x, m_Extent.y }
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      m_Conductances[axis] = Memory<float>(m_Grid.GetLength());
      m_Conductances[axis].Upload(volume.conductances[axis]);
    }
    m_Edges = { m_Conductances[0].Get(),
                m_Conductances[1].Get(),
                m_Conductances[2].Get(),
                static_cast<std::ptrdiff_t>(m_Grid.GetStride(1)),
                static_cast<std::ptrdiff_t>(m_Grid.GetStride(2)) };
    if (m_Heat)
    {
      this->Upload(Heat, m_Heat);
    }
  }

  void
  Upload(Field field, const float * values) override
  {
    DeviceRuntime::CopyBytes(this->Get(field), values, m_Grid.GetLength() * sizeof(float));
  }

  void
  Download(Field field, float * values, std::size_t first, std::size_t number) override
  {
    const std::size_t begin = (first + 1) * m_Grid.GetStride(2);
    DeviceRuntime::CopyBytes(values + begin, this->Get(field) + begin, number * m_Grid.GetStride(2) * sizeof(float));
  }

  unsigned int
  GetLongestStretch(bool) const override
  {
    return 64; // a few milliseconds between progress reports
  }

  void
  Copy(Field from, Field to) override
  {
    DeviceRuntime::CopyBytes(this->Get(to), this->Get(from), m_Grid.GetLength() * sizeof(float));
  }

  void
  Exchange(Field a, Field b) override
  {
    m_Fields[a].Swap(m_Fields[b]);
  }

  void
  Clear(Field field) override
  {
    this->Get(field);
    m_Fields[field].Clear();
  }

  void
  Scale(Field from, Field to, float factor, SliceStride) override
  {
    DeviceRuntime::ForVoxels(m_Extent, Scaled{ m_Places, this->Get(from), this->Get(to), factor });
  }

  void
  ClampToZero(Field field, SliceStride) override
  {
    DeviceRuntime::ForVoxels(m_Extent, Clamped{ m_Places, this->Get(field) });
  }

  void
  StepExplicitly(unsigned int steps, float dt, bool compensated) override
  {
    for (unsigned int step = 0; step < steps; ++step)
    {
      float * const from = this->Get(Heat);
      float * const to = this->Get(Even);
      if (compensated)
      {
        DeviceRuntime::ForVoxels(m_Extent, Compensated{ m_Places, m_Edges, from, to, this->Get(Odd), dt });
      }
      else
      {
        DeviceRuntime::ForVoxels(m_Extent, Explicit{ m_Places, m_Edges, from, to, dt });
      }
      this->Exchange(Heat, Even);
    }
    DeviceRuntime::Synchronize();
  }

  void
  StepChebyshev(std::size_t done, unsigned int steps, float scale, const Expansions & coefficients, SliceStride)
    override
  {
    for (std::size_t k = done + 2; k <= done + steps; k += 2)
    {
      TwoChebyshevSteps body{ m_Places,
                              m_Edges,
                              this->Get(Even),
                              this->Get(Difference),
                              this->Get(Odd),
                              this->Get(NextDifference),
                              k == 2 ? 0.5F * scale : scale,
                              scale,
                              0,
                              {},
                              {} };
      for (std::size_t g = 0; g < coefficients.size(); ++g)
      {
        if (FindPair(coefficients[g], k, body.terms[body.pairs]))
        {
          body.nodes[body.pairs++] = this->Get(FirstNode + static_cast<Field>(g));
        }
      }
      DeviceRuntime::ForVoxelsTwice(m_Extent, body);
      this->Exchange(Even, Odd);
      this->Exchange(Difference, NextDifference);
    }
    DeviceRuntime::Synchronize();
  }

  std::uint64_t
  CountMoved(Field before, Field after, float change, float least) override
  {
    const Moved moved{ m_Numbered, this->Get(before), this->Get(after), change, least };
    return DeviceRuntime::Reduce<Sum>(m_Grid.GetNumberOfVoxels(), moved).number;
  }

  void
  Show(std::size_t snapshot, Field field) override
  {
    if (m_Snapshots->IsCounted(snapshot))
    {
      this->CountRows<1>(snapshot, BinOfField{ m_Numbered, this->Get(field) }, m_Extent.z, 1);
    }
    this->ShowField(snapshot, field);
  }

  void
  ShowCombined(std::size_t                          first,
               const std::array<Field, MostNodes> & nodes,
               const std::vector<Weights> &         weights,
               SliceStride                          stride) override
  {
    Combination combination{};
    for (std::size_t k = 0; k < MostNodes; ++k)
    {
      combination.nodes[k] = this->Get(nodes[k]);
    }
    for (std::size_t i = 0; i < weights.size(); ++i)
    {
      combination.weights[0] = weights[i];
      if (m_Snapshots->IsShown(first + i))
      {
        // Difference is unused between two expansions.
        DeviceRuntime::ForVoxels(m_Extent, CombinedField{ m_Places, combination, this->Get(Difference) });
        this->ShowField(first + i, Difference);
      }
    }
    this->CountCombined(first, combination, weights, 0, m_Extent.z / stride, stride);
    if (const std::size_t rest = m_Extent.z % stride; rest > 0)
    {
      this->CountCombined(first, combination, weights, m_Extent.z - rest, 1, rest);
    }
  }

  void
  Finish() override
  {
    this->Download(Heat, m_Heat, 0, m_Extent.z);
  }

private:
  static constexpr Field NextDifference = MostFields;

  float *
  Get(Field field)
  {
    if (!m_Fields[field].Get())
    {
      m_Fields[field] = Memory<float>(m_Grid.GetLength());
      m_Fields[field].Clear(); // the border of the volume stays at 0
    }
    return m_Fields[field].Get();
  }

  void
  ShowField(std::size_t snapshot, Field field)
  {
    if (m_Snapshots->IsShown(snapshot))
    {
      std::vector<float> values(m_Grid.GetLength());
      this->Download(field, values.data(), 0, m_Extent.z);
      for (std::size_t row = 0; row < m_Extent.y * m_Extent.z; ++row)
      {
        m_Snapshots->ShowRow(snapshot, row, values.data() + m_Grid.GetRow(row % m_Extent.y, row / m_Extent.y), 0);
      }
    }
  }

  /** Counts slices that stand for `stride` slices each. Processes two snapshots at once to read each node once. */
  void
  CountCombined(std::size_t                  first,
                Combination                  combination,
                const std::vector<Weights> & weights,
                std::size_t                  firstSlice,
                std::size_t                  slices,
                SliceStride                  stride)
  {
    const Numbered numbered{ m_Places, m_Extent.x, m_Extent.y, stride, firstSlice };
    for (std::size_t i = 0; i < weights.size();)
    {
      const bool two =
        i + 1 < weights.size() && m_Snapshots->IsCounted(first + i) && m_Snapshots->IsCounted(first + i + 1);
      combination.weights[0] = weights[i];
      combination.weights[1] = weights[two ? i + 1 : i];
      if (two)
      {
        this->CountRows<2>(first + i, BinOfCombination{ numbered, combination }, slices, stride);
      }
      else if (m_Snapshots->IsCounted(first + i))
      {
        this->CountRows<1>(first + i, BinOfCombination{ numbered, combination }, slices, stride);
      }
      i += two ? 2 : 1;
    }
  }

  template <unsigned int VRows, typename TBody>
  void
  CountRows(std::size_t snapshot, const TBody & body, std::size_t slices, SliceStride weight)
  {
    constexpr unsigned int bins = HeatHistogram::NumberOfBins;
    m_Counts.Clear();
    DeviceRuntime::Count<bins, VRows>(m_Extent.x * m_Extent.y * slices, body, m_Counts.Get());
    std::vector<std::uint32_t> values(m_Counts.GetNumber());
    m_Counts.Download(values.data());
    for (unsigned int row = 0; row < VRows; ++row)
    {
      m_Snapshots->AddCounts(snapshot + row, values.data() + row * bins, static_cast<std::uint32_t>(weight));
    }
  }

  PaddedGrid                                m_Grid;
  float *                                   m_Heat;
  HeatSnapshots *                           m_Snapshots;
  DeviceRuntime::Extent                     m_Extent;
  Places                                    m_Places;
  Numbered                                  m_Numbered;
  std::array<Memory<float>, 3>              m_Conductances;
  DiffusionEdges                            m_Edges{};
  std::array<Memory<float>, MostFields + 1> m_Fields;
  Memory<std::uint32_t>                     m_Counts{ 2 * HeatHistogram::NumberOfBins }; // of two snapshots
};
} // namespace

SHAPETON_DEVICE_FUNCTION DeviceHeatEngine *
ShapetonMakeHeatEngine(const DeviceHeatVolume & volume, float * heat, HeatSnapshots * snapshots)
{
  return new Engine(volume, heat, snapshots);
}
} // namespace shapeton
