#include "shapetonHeatDiffusionSolver.h"
#include "shapetonDiffusionKernels.h"
#include "shapetonKernelSets.h"
#include "shapetonTimeTiles.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <functional>
#include <stdexcept>

namespace shapeton
{
/** A stretch of time at whose nodes fields are computed. The requested steps in it are nodes, or are interpolated. */
struct HeatDiffusionSolver::Interval
{
  std::uint64_t              start;
  std::uint64_t              end;
  std::size_t                endSnapshot; // the number of requested steps up to the end
  std::vector<std::uint64_t> nodes;       // without the start
  bool                       interpolate;
};

namespace
{
using DiffusionArithmetic::NumberOfNodes;

// Measured on 256^3: the tile's rows of all fields stay in the cache while it moves.
constexpr TimeTileShape explicitTile{ 32, 32, 16 };
constexpr TimeTileShape chebyshevTile{ 16, 16, 8 };

// Time intervals with this end / start ratio and seven nodes give 1.3e-6; see the class documentation.
constexpr double        intervalRatio = 2.5;
constexpr std::uint64_t explicitStart = 16;

// A long stretch of time is cut where the ratio to its start would exceed this: rounding errors grow with the degree of
// an expansion and with the fine detail of its start, which the stretch before has smoothed away.
constexpr std::uint64_t longestRatio = 32;
constexpr std::uint64_t shortestStretch = 1000;

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

/** Calls body(row number, place in memory, worker) for all rows, in parallel over slices. */
template <typename TBody>
void
ForAllRows(const PaddedGrid & grid, const TBody & body)
{
  const std::size_t ny = grid.GetSize()[1];
  ParallelForWorkers(grid.GetSize()[2], [&](std::size_t z, unsigned int worker) {
    const FlushToZero flushToZero;
    for (std::size_t y = 0; y < ny; ++y)
    {
      body(y + ny * z, grid.GetRow(y, z), worker);
    }
  });
}

void
CopyField(const PaddedGrid & grid, const PaddedField & from, PaddedField & to)
{
  std::memcpy(to.GetData(), from.GetData(), grid.GetLength() * sizeof(float));
}

/** Seven Lobatto nodes in log(step), rounded to whole steps; the start is not returned. */
std::vector<std::uint64_t>
LobattoNodes(std::uint64_t start, std::uint64_t end)
{
  std::vector<std::uint64_t> nodes;
  const double               from = std::log(static_cast<double>(start));
  const double               to = std::log(static_cast<double>(end));
  std::uint64_t              previous = start;
  for (std::size_t k = 1; k < NumberOfNodes; ++k)
  {
    const double position = 0.5 * (from + to) - 0.5 * (to - from) * std::cos(M_PI * k / (NumberOfNodes - 1.0));
    const auto   node = static_cast<std::uint64_t>(std::llround(std::exp(position)));
    previous = k + 1 == NumberOfNodes ? end : std::max(node, previous + 1);
    nodes.push_back(previous);
  }
  return nodes;
}

bool
IsSteadyBetween(const PaddedGrid &                      grid,
                const PaddedField &                     before,
                const PaddedField &                     after,
                const HeatDiffusionSolver::SteadyRule & rule)
{
  const std::size_t          nx = grid.GetSize()[0];
  const std::size_t          ny = grid.GetSize()[1];
  const auto                 change = static_cast<float>(rule.change);
  const auto                 least = static_cast<float>(rule.leastHeat);
  std::vector<std::uint64_t> moved(grid.GetSize()[2], 0);
  ForAllRows(grid, [&](std::size_t row, std::size_t place, unsigned int) {
    for (std::size_t i = place; i < place + nx; ++i)
    {
      const float heat = after.GetData()[i];
      moved[row / ny] += std::abs(heat - before.GetData()[i]) > change * std::max(heat, least) ? 1 : 0;
    }
  });
  std::uint64_t total = 0;
  for (const std::uint64_t number : moved)
  {
    total += number;
  }
  return static_cast<double>(total) <= rule.voxels * static_cast<double>(grid.GetNumberOfVoxels());
}
} // namespace

std::vector<HeatDiffusionSolver::Interval>
HeatDiffusionSolver::PlanIntervals(std::uint64_t                      start,
                                   std::uint64_t                      last,
                                   const std::vector<std::uint64_t> & steps,
                                   bool                               checkSteady)
{
  std::vector<Interval> plan;
  std::size_t           snapshot = std::upper_bound(steps.begin(), steps.end(), start) - steps.begin();
  while (start < last)
  {
    std::uint64_t end = last;
    while (end > shortestStretch && end > longestRatio * start)
    {
      end = (end + longestRatio - 1) / longestRatio;
    }
    Interval   interval{ start, std::max(end, start + 1), snapshot, {}, false };
    const auto ratioEnd = static_cast<std::uint64_t>(std::ceil(std::max(start * intervalRatio, explicitStart * 1.0)));
    const std::size_t few = NumberOfNodes - 1;
    if (checkSteady)
    {
      interval.end = std::min(last, ratioEnd);
    }
    else if (steps.size() - snapshot > few) // as far as the requested steps themselves can be the nodes, or the ratio
    {
      interval.end = std::min(interval.end, std::max(steps[snapshot + few - 1], ratioEnd));
    }
    interval.endSnapshot = std::upper_bound(steps.begin(), steps.end(), interval.end) - steps.begin();
    if (interval.endSnapshot - snapshot <= few)
    {
      interval.nodes.assign(steps.begin() + snapshot, steps.begin() + interval.endSnapshot);
      if (interval.nodes.empty() || interval.nodes.back() != interval.end)
      {
        interval.nodes.push_back(interval.end);
      }
    }
    else
    {
      interval.interpolate = true;
      interval.nodes = LobattoNodes(start, interval.end);
    }
    start = interval.end;
    snapshot = interval.endSnapshot;
    plan.push_back(interval);
  }
  return plan;
}

std::array<float, 7>
HeatDiffusionSolver::InterpolationWeights(const Interval & interval, std::uint64_t step)
{
  std::array<double, NumberOfNodes> node{};
  node[0] = std::log(static_cast<double>(interval.start));
  std::transform(interval.nodes.begin(), interval.nodes.end(), node.begin() + 1, [](std::uint64_t s) {
    return std::log(static_cast<double>(s));
  });
  std::array<float, NumberOfNodes> weights{};
  const double                     position = std::log(static_cast<double>(step));
  const auto                       hit = std::find(node.begin(), node.end(), position);
  if (hit != node.end())
  {
    weights[hit - node.begin()] = 1.0F;
    return weights;
  }
  std::array<double, NumberOfNodes> raw{};
  double                            sum = 0.0;
  for (std::size_t k = 0; k < NumberOfNodes; ++k)
  {
    raw[k] = 1.0 / (position - node[k]);
    for (std::size_t j = 0; j < NumberOfNodes; ++j)
    {
      raw[k] /= j == k ? 1.0 : node[k] - node[j];
    }
    sum += raw[k];
  }
  for (std::size_t k = 0; k < NumberOfNodes; ++k)
  {
    weights[k] = static_cast<float>(raw[k] / sum);
  }
  return weights;
}

/** The fields of a run, allocated when they are first needed. Those of a large volume take a while: each is told. */
class HeatDiffusionSolver::Workspace
{
public:
  Workspace(const PaddedGrid & grid, std::function<void()> allocated) : m_Grid(grid), m_Allocated(std::move(allocated))
  {}

  PaddedField &
  Get(std::size_t number)
  {
    while (m_Fields.size() <= number)
    {
      m_Fields.emplace_back(m_Grid);
      m_Allocated();
    }
    return m_Fields[number];
  }

private:
  const PaddedGrid &      m_Grid;
  std::function<void()>   m_Allocated;
  std::deque<PaddedField> m_Fields; // growing leaves references valid
};

HeatDiffusionSolver::HeatDiffusionSolver(const VolumeGradientOperator & volumeGradient,
                                         Method                         method,
                                         double                         timeStepLength,
                                         double                         tolerance)
  : m_VolumeGradient(volumeGradient), m_Method(method), m_TimeStepLength(timeStepLength), m_Tolerance(tolerance)
{
  if (!(timeStepLength > 0.0) ||
      timeStepLength > MaximumTimeStepLength * (1.0 + 1e-6)) // 0.08333333 is meant to be 1/12
  {
    throw std::invalid_argument("the length of a time step must be positive and at most 1/12");
  }
  if (!(tolerance >= 1e-6) || tolerance > 1.0)
  {
    throw std::invalid_argument("the tolerance must lie between 1e-6 and 1");
  }
}

std::vector<double>
HeatDiffusionSolver::ChebyshevCoefficients(std::uint64_t steps, double beta, double tolerance)
{
  if (steps == 0)
  {
    return { 1.0 };
  }
  // Samples of the function at the Chebyshev points, then a cosine transform.
  const auto          t = static_cast<double>(steps);
  const std::size_t   degree = static_cast<std::size_t>(std::sqrt(1.2 * t * beta * std::log(4.0 / tolerance))) + 16;
  const std::size_t   points = 2 * degree + 32;
  std::vector<double> samples(points);
  for (std::size_t j = 0; j < points; ++j)
  {
    const double sine = std::sin(0.5 * M_PI * (j + 0.5) / points);
    samples[j] = std::exp(t * std::log1p(-beta * sine * sine)); // (1 - x) / 2 = sine^2
  }
  // Late samples underflow to 0: for a billion steps all but a few thousand of them.
  const std::size_t   used = std::find(samples.begin(), samples.end(), 0.0) - samples.begin();
  std::vector<double> coefficients(degree + 1);
  ParallelFor(degree + 1, [&](std::size_t k) {
    const double angle = M_PI * k / points;
    const double twice = 2.0 * std::cos(angle);
    double       previous = std::cos(0.5 * angle);
    double       cosine = previous;
    double       sum = 0.0;
    for (std::size_t j = 0; j < used; ++j) // cos(k pi (j + 1/2) / points) by recurrence
    {
      sum += samples[j] * cosine;
      const double following = twice * cosine - previous;
      previous = cosine;
      cosine = following;
    }
    coefficients[k] = sum * (k == 0 ? 1.0 : 2.0) / points;
  });
  double rest = 0.0;
  while (coefficients.size() > 1 && rest + std::abs(coefficients.back()) <= tolerance)
  {
    rest += std::abs(coefficients.back());
    coefficients.pop_back();
  }
  return coefficients;
}

void
HeatDiffusionSolver::ReportProgress(double applications)
{
  m_Applications += static_cast<std::uint64_t>(applications);
  m_Progress(std::min(1.0, static_cast<double>(m_Applications) / m_PlannedApplications));
}

void
HeatDiffusionSolver::Advance(PaddedField & heat, std::uint64_t steps, Sums sums, Workspace & workspace)
{
  const PaddedGrid & grid = m_VolumeGradient.GetGrid();
  const std::size_t  nx = grid.GetSize()[0];
  const auto         dt = static_cast<float>(m_TimeStepLength);
  PaddedField &      other = workspace.Get(0);
  PaddedField &      rest = workspace.Get(1);
  std::memset(rest.GetData(), 0, grid.GetLength() * sizeof(float));
  while (steps > 0)
  {
    const auto count = static_cast<unsigned int>(std::min<std::uint64_t>(steps, explicitTile.steps));
    float *    buffers[2] = { heat.GetData(), other.GetData() };
    RunTimeTiles(grid, count, explicitTile, [&](unsigned int step, std::size_t row) {
      const auto    edges = EdgesOfRow(m_VolumeGradient, row);
      const float * current = buffers[(step + 1) % 2] + row;
      float *       next = buffers[step % 2] + row;
      if (sums == Sums::Plain)
      {
        Kernels().ExplicitStep(edges, current, next, nx, dt);
        return;
      }
      Kernels().CompensatedStep(edges, current, next, rest.GetData() + row, nx, dt);
    });
    if (count % 2 == 1)
    {
      std::swap(heat, other);
    }
    steps -= count;
    this->ReportProgress(count);
  }
}

void
HeatDiffusionSolver::Expand(const PaddedField &                start,
                            const Expansions &                 coefficients,
                            const std::vector<PaddedField *> & results,
                            Workspace &                        workspace)
{
  const PaddedGrid & grid = m_VolumeGradient.GetGrid();
  const std::size_t  nx = grid.GetSize()[0];
  const auto         step = static_cast<float>(2.0 / m_VolumeGradient.GetEigenvalueBound());
  PaddedField &      even = workspace.Get(0); // T_k of even and odd k
  PaddedField &      odd = workspace.Get(1);
  PaddedField &      difference = workspace.Get(2);
  CopyField(grid, start, even);
  std::memset(difference.GetData(), 0, grid.GetLength() * sizeof(float));
  this->ReportProgress(0.0);
  ForAllRows(grid, [&](std::size_t, std::size_t row, unsigned int) {
    for (std::size_t g = 0; g < results.size(); ++g)
    {
      Kernels().Scale(results[g]->GetData() + row, start.GetData() + row, nx, static_cast<float>(coefficients[g][0]));
    }
  });
  std::size_t degree = 0;
  for (const auto & c : coefficients)
  {
    degree = std::max(degree, c.size() - 1);
  }
  const auto coefficient = [&](std::size_t g, std::size_t k) {
    return k < coefficients[g].size() ? static_cast<float>(coefficients[g][k]) : 0.0F;
  };
  for (std::size_t done = 0; done < degree; done += chebyshevTile.steps)
  {
    // An even number of terms, so that they can be added in pairs.
    const auto count =
      static_cast<unsigned int>(std::min<std::size_t>(chebyshevTile.steps, (degree - done + 1) / 2 * 2));
    float * buffers[2] = { even.GetData(), odd.GetData() };
    RunTimeTiles(grid, count, chebyshevTile, [&](unsigned int s, std::size_t row) {
      const std::size_t   k = done + s;
      const float * const current = buffers[(k + 1) % 2] + row;
      float * const       next = buffers[k % 2] + row;
      Kernels().ChebyshevStep(
        EdgesOfRow(m_VolumeGradient, row), current, next, difference.GetData() + row, nx, k == 1 ? step : 2.0F * step);
      for (std::size_t g = 0; k % 2 == 0 && g < results.size(); ++g)
      {
        if (k - 1 < coefficients[g].size())
        {
          Kernels().AddPair(results[g]->GetData() + row, next, current, nx, coefficient(g, k), coefficient(g, k - 1));
        }
      }
    });
    this->ReportProgress(count);
  }
}

/** Shows the visitor the heat after each requested step. */
class HeatDiffusionSolver::Recorder
{
public:
  Recorder(const PaddedGrid & grid, const std::vector<std::uint64_t> & steps, const Visitor & visitor)
    : m_Grid(grid), m_Steps(steps), m_Visitor(visitor)
  {}

  /** The next requested step, or `otherwise` when there is none before it. */
  std::uint64_t
  Next(std::uint64_t otherwise) const
  {
    return m_Next < m_Steps.size() ? std::min(m_Steps[m_Next], otherwise) : otherwise;
  }

  /** `heat` is the field after `step`. */
  void
  Show(const PaddedField & heat, std::uint64_t step)
  {
    for (; m_Next < m_Steps.size() && m_Steps[m_Next] == step; ++m_Next)
    {
      ForAllRows(m_Grid, [&](std::size_t row, std::size_t place, unsigned int worker) {
        m_Visitor(m_Next, row, heat.GetData() + place, worker);
      });
    }
  }

  /** Interpolates all requested steps of the interval between the fields at its nodes. */
  void
  ShowInterpolated(const Interval &                   interval,
                   const PaddedField &                start,
                   const std::vector<PaddedField *> & nodes,
                   const std::function<void()> &      afterGroup)
  {
    while (m_Next < interval.endSnapshot)
    {
      const std::size_t end = std::min(m_Next + snapshotsAtOnce, interval.endSnapshot);
      this->ShowGroup(interval, start, nodes, end);
      m_Next = end;
      afterGroup();
    }
  }

private:
  // Whole volumes that a visitor collects are complete after each group: few of them are open at once.
  static constexpr std::size_t snapshotsAtOnce = 4;

  void
  ShowGroup(const Interval &                   interval,
            const PaddedField &                start,
            const std::vector<PaddedField *> & nodes,
            std::size_t                        end) const
  {
    std::vector<std::array<float, NumberOfNodes>> weights;
    for (std::size_t snapshot = m_Next; snapshot < end; ++snapshot)
    {
      weights.push_back(InterpolationWeights(interval, m_Steps[snapshot]));
    }
    const std::size_t               nx = m_Grid.GetSize()[0];
    std::vector<std::vector<float>> buffers(NumberOfThreads(), std::vector<float>(nx));
    ForAllRows(m_Grid, [&](std::size_t row, std::size_t place, unsigned int worker) {
      std::array<const float *, NumberOfNodes> rows{ start.GetData() + place };
      std::transform(
        nodes.begin(), nodes.end(), rows.begin() + 1, [place](PaddedField * node) { return node->GetData() + place; });
      for (std::size_t i = 0; i < weights.size(); ++i)
      {
        Kernels().Combine(buffers[worker].data(), rows.data(), nx, weights[i].data());
        m_Visitor(m_Next + i, row, buffers[worker].data(), worker);
      }
    });
  }

  const PaddedGrid &                 m_Grid;
  const std::vector<std::uint64_t> & m_Steps;
  const Visitor &                    m_Visitor;
  std::size_t                        m_Next{ 0 };
};

std::uint64_t
HeatDiffusionSolver::Run(PaddedField &                      heat,
                         std::uint64_t                      lastStep,
                         const std::vector<std::uint64_t> & steps,
                         const Visitor &                    visitor)
{
  const bool ascend = std::adjacent_find(steps.begin(), steps.end(), std::greater_equal<>()) == steps.end();
  if (!ascend || (!steps.empty() && steps.back() > lastStep))
  {
    throw std::invalid_argument("the steps to record must ascend and none may lie beyond the last step");
  }
  m_Steady = false;
  m_Applications = 0;
  Workspace workspace(m_VolumeGradient.GetGrid(), [this] { this->ReportProgress(0.0); });
  Recorder  recorder(m_VolumeGradient.GetGrid(), steps, visitor);
  recorder.Show(heat, 0);
  return m_Method == Method::Explicit ? this->RunExplicitly(heat, lastStep, recorder, workspace)
                                      : this->RunByExpansion(heat, lastStep, steps, recorder, workspace);
}

std::uint64_t
HeatDiffusionSolver::RunExplicitly(PaddedField & heat,
                                   std::uint64_t lastStep,
                                   Recorder &    recorder,
                                   Workspace &   workspace)
{
  const PaddedGrid & grid = m_VolumeGradient.GetGrid();
  m_PlannedApplications = static_cast<double>(lastStep);
  std::uint64_t step = 0;
  while (step < lastStep && !m_Steady)
  {
    // Stretches of the time ratio, for the check of the steady state.
    const auto end =
      m_StopWhenSteady
        ? std::min(lastStep, std::max(explicitStart, static_cast<std::uint64_t>(std::ceil(step * intervalRatio))))
        : lastStep;
    const std::uint64_t start = step;
    const bool          check = m_StopWhenSteady && start > 0;
    if (check)
    {
      CopyField(grid, heat, workspace.Get(2));
    }
    while (step < end)
    {
      const std::uint64_t next = recorder.Next(end);
      this->Advance(heat, next - step, Sums::Compensated, workspace);
      step = next;
      recorder.Show(heat, step);
    }
    m_Steady = check && end >= intervalRatio * start && IsSteadyBetween(grid, workspace.Get(2), heat, m_SteadyRule);
  }
  return step;
}

std::uint64_t
HeatDiffusionSolver::RunByExpansion(PaddedField &                      heat,
                                    std::uint64_t                      lastStep,
                                    const std::vector<std::uint64_t> & steps,
                                    Recorder &                         recorder,
                                    Workspace &                        workspace)
{
  const PaddedGrid & grid = m_VolumeGradient.GetGrid();
  const bool         dense = m_StopWhenSteady || steps.size() >= NumberOfNodes;
  std::uint64_t      step = 0;
  const auto         start = dense ? std::min(explicitStart, lastStep) : 0;
  const auto         plan = PlanIntervals(start, lastStep, steps, m_StopWhenSteady);
  const auto         expansions = this->PlanExpansions(start, plan);

  while (step < start)
  {
    const std::uint64_t next = recorder.Next(start);
    this->Advance(heat, next - step, Sums::Plain, workspace);
    step = next;
    recorder.Show(heat, step);
  }
  for (std::size_t i = 0; i < plan.size() && !m_Steady; ++i)
  {
    std::vector<PaddedField *> nodes;
    for (std::size_t k = 0; k < plan[i].nodes.size(); ++k)
    {
      nodes.push_back(&workspace.Get(3 + k));
    }
    this->Expand(heat, expansions[i], nodes, workspace);
    for (PaddedField * const node : nodes)
    {
      ForAllRows(grid, [&](std::size_t, std::size_t place, unsigned int) {
        Kernels().ClampToZero(node->GetData() + place, grid.GetSize()[0]);
      });
    }
    if (plan[i].interpolate)
    {
      recorder.ShowInterpolated(plan[i], heat, nodes, [this] { this->ReportProgress(0.0); });
    }
    else
    {
      for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        recorder.Show(*nodes[k], plan[i].nodes[k]);
        this->ReportProgress(0.0); // lets the visitor hand out what is complete
      }
    }
    // A last interval that was cut short is too short to tell.
    m_Steady = m_StopWhenSteady && plan[i].end >= intervalRatio * plan[i].start &&
               IsSteadyBetween(grid, heat, *nodes.back(), m_SteadyRule);
    std::swap(heat, *nodes.back());
    step = plan[i].end;
  }
  return step;
}

std::vector<HeatDiffusionSolver::Expansions>
HeatDiffusionSolver::PlanExpansions(std::uint64_t explicitSteps, const std::vector<Interval> & plan)
{
  const double            beta = std::min(1.0, m_TimeStepLength * m_VolumeGradient.GetEigenvalueBound());
  const double            truncation = 0.02 * m_Tolerance; // rounding takes most of the tolerance
  std::vector<Expansions> expansions;
  m_PlannedApplications = static_cast<double>(explicitSteps);
  for (const Interval & interval : plan)
  {
    Expansions  ofNodes;
    std::size_t degree = 0;
    for (const std::uint64_t node : interval.nodes)
    {
      ofNodes.push_back(ChebyshevCoefficients(node - interval.start, beta, truncation));
      degree = std::max(degree, ofNodes.back().size() / 2 * 2); // terms are added in pairs
    }
    expansions.push_back(std::move(ofNodes));
    m_PlannedApplications += static_cast<double>(degree);
  }
  return expansions;
}
} // namespace shapeton
