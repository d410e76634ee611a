#include "shapetonHeatDiffusionSolver.h"
#include "shapetonHeatEngineOnCpu.h"
#include "shapetonHeatEngineOnGpu.h"
#include "shapetonParallelFor.h"
#include "shapetonPi.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>

namespace shapeton
{
/** A time interval with fields at its nodes. Requested steps are nodes or interpolated. */
struct HeatDiffusionSolver::Interval
{
  std::uint64_t              start;
  std::uint64_t              end;
  std::size_t                endSnapshot; // the number of requested steps up to the end
  std::vector<std::uint64_t> nodes;       // excluding the start
  bool                       interpolate;
};

namespace
{
constexpr std::size_t NumberOfNodes = HeatEngine::MostNodes;

// Time intervals with this end / start ratio and seven nodes achieve an error of 1.3e-6; see the class documentation.
constexpr double        intervalRatio = 2.5;
constexpr std::uint64_t explicitStart = 16;

// A long time interval is split if its end / start ratio would exceed this: rounding errors grow with the degree of an
// expansion and with the fine detail of its initial field, which earlier intervals smooth out.
constexpr std::uint64_t longestRatio = 32;
constexpr std::uint64_t shortestStretch = 1000;

/** Seven Lobatto nodes in log(step), rounded to integers; the start is not returned. */
std::vector<std::uint64_t>
LobattoNodes(std::uint64_t start, std::uint64_t end)
{
  std::vector<std::uint64_t> nodes;
  const double               from = std::log(static_cast<double>(start));
  const double               to = std::log(static_cast<double>(end));
  std::uint64_t              previous = start;
  for (std::size_t k = 1; k < NumberOfNodes; ++k)
  {
    const double position = 0.5 * (from + to) - 0.5 * (to - from) * std::cos(Pi * k / (NumberOfNodes - 1.0));
    const auto   node = static_cast<std::uint64_t>(std::llround(std::exp(position)));
    previous = k + 1 == NumberOfNodes ? end : std::max(node, previous + 1);
    nodes.push_back(previous);
  }
  return nodes;
}

bool
IsSteadyBetween(HeatEngine &                            engine,
                std::size_t                             voxels,
                HeatEngine::Field                       before,
                HeatEngine::Field                       after,
                const HeatDiffusionSolver::SteadyRule & rule)
{
  const std::uint64_t moved =
    engine.CountMoved(before, after, static_cast<float>(rule.change), static_cast<float>(rule.leastHeat));
  return static_cast<double>(moved) <= rule.voxels * static_cast<double>(voxels);
}

/** Passes all snapshots to a visitor. */
class VisitedSnapshots : public HeatSnapshots
{
public:
  explicit VisitedSnapshots(const HeatDiffusionSolver::Visitor & visitor) : m_Visitor(visitor) {}
  void
  ShowRow(std::size_t snapshot, std::size_t row, const float * heat, unsigned int worker) override
  {
    m_Visitor(snapshot, row, heat, worker);
  }

private:
  const HeatDiffusionSolver::Visitor & m_Visitor;
};
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
    else if (steps.size() - snapshot > few) // to the last step that can be a node, at least to the ratio
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

std::array<float, NumberOfNodes>
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

HeatDiffusionSolver::HeatDiffusionSolver(const VolumeGradientOperator & volumeGradient,
                                         Method                         method,
                                         double                         timeStepLength,
                                         double                         tolerance)
  : m_VolumeGradient(volumeGradient), m_Method(method), m_TimeStepLength(timeStepLength), m_Tolerance(tolerance)
{
  constexpr double rounding = 1e-6; // accepts 0.08333333 as 1/12
  constexpr double leastTolerance = 1e-6;
  if (!(timeStepLength > 0.0) || timeStepLength > MaximumTimeStepLength * (1.0 + rounding))
  {
    throw std::invalid_argument("the time step must be positive and at most 1/12");
  }
  if (!(tolerance >= leastTolerance) || tolerance > 1.0)
  {
    throw std::invalid_argument("the tolerance must be between 1e-6 and 1");
  }
}

std::vector<double>
HeatDiffusionSolver::ChebyshevCoefficients(std::uint64_t steps, double beta, double tolerance)
{
  if (steps == 0)
  {
    return { 1.0 };
  }
  // Samples the function at the Chebyshev points, then applies a cosine transform.
  const auto          t = static_cast<double>(steps);
  const std::size_t   degree = static_cast<std::size_t>(std::sqrt(1.2 * t * beta * std::log(4.0 / tolerance))) + 16;
  const std::size_t   points = 2 * degree + 32;
  std::vector<double> samples(points);
  for (std::size_t j = 0; j < points; ++j)
  {
    const double sine = std::sin(0.5 * Pi * (j + 0.5) / points);
    samples[j] = std::exp(t * std::log1p(-beta * sine * sine)); // (1 - x) / 2 = sine^2
  }
  // Late samples underflow to 0; for a billion steps, only a few thousand remain.
  const std::size_t   used = std::find(samples.begin(), samples.end(), 0.0) - samples.begin();
  std::vector<double> coefficients(degree + 1);
  ParallelFor(degree + 1, [&](std::size_t k) {
    const double angle = Pi * k / points;
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
HeatDiffusionSolver::Advance(HeatEngine & engine, std::uint64_t steps, Sums sums)
{
  const auto dt = static_cast<float>(m_TimeStepLength);
  engine.Clear(HeatEngine::Odd);
  while (steps > 0)
  {
    const auto count = static_cast<unsigned int>(std::min<std::uint64_t>(steps, engine.GetLongestStretch(false)));
    engine.StepExplicitly(count, dt, sums == Sums::Compensated);
    steps -= count;
    this->ReportProgress(count);
  }
}

void
HeatDiffusionSolver::Expand(HeatEngine & engine, const Expansions & coefficients)
{
  const auto step = static_cast<float>(2.0 / m_VolumeGradient.GetEigenvalueBound());
  engine.Copy(HeatEngine::Heat, HeatEngine::Even);
  engine.Clear(HeatEngine::Difference);
  this->ReportProgress(0.0);
  std::size_t degree = 0;
  for (std::size_t g = 0; g < coefficients.size(); ++g)
  {
    const auto node = HeatEngine::FirstNode + static_cast<HeatEngine::Field>(g);
    engine.Scale(HeatEngine::Heat, node, static_cast<float>(coefficients[g][0]));
    degree = std::max(degree, coefficients[g].size() - 1);
  }
  const std::size_t longest = engine.GetLongestStretch(true);
  for (std::size_t done = 0; done < degree; done += longest)
  {
    // Makes the number of terms even, because they are added in pairs.
    const auto count = static_cast<unsigned int>(std::min(longest, (degree - done + 1) / 2 * 2));
    engine.StepChebyshev(done, count, 2.0F * step, coefficients);
    this->ReportProgress(count);
  }
}

/** Passes the heat after each requested step to the snapshots. */
class HeatDiffusionSolver::Recorder
{
public:
  Recorder(HeatEngine & engine, const std::vector<std::uint64_t> & steps) : m_Engine(engine), m_Steps(steps) {}

  /** The next requested step, but at most `otherwise`. */
  std::uint64_t
  Next(std::uint64_t otherwise) const
  {
    return m_Next < m_Steps.size() ? std::min(m_Steps[m_Next], otherwise) : otherwise;
  }

  /** `field` is the heat after `step`. */
  void
  Show(HeatEngine::Field field, std::uint64_t step)
  {
    for (; m_Next < m_Steps.size() && m_Steps[m_Next] == step; ++m_Next)
    {
      m_Engine.Show(m_Next, field);
    }
  }

  /** Interpolates all requested steps of the interval between the heat and the fields at its nodes. */
  void
  ShowInterpolated(const Interval & interval, const std::function<void()> & afterGroup)
  {
    std::array<HeatEngine::Field, NumberOfNodes> nodes{ HeatEngine::Heat };
    for (std::size_t k = 1; k < NumberOfNodes; ++k)
    {
      nodes[k] = HeatEngine::FirstNode + static_cast<HeatEngine::Field>(k - 1);
    }
    while (m_Next < interval.endSnapshot)
    {
      const std::size_t                end = std::min(m_Next + snapshotsAtOnce, interval.endSnapshot);
      std::vector<HeatEngine::Weights> weights;
      for (std::size_t snapshot = m_Next; snapshot < end; ++snapshot)
      {
        weights.push_back(InterpolationWeights(interval, m_Steps[snapshot]));
      }
      m_Engine.ShowCombined(m_Next, nodes, weights);
      m_Next = end;
      afterGroup();
    }
  }

private:
  // Collected volumes are complete after each group, which limits memory.
  static constexpr std::size_t snapshotsAtOnce = 4;

  HeatEngine &                       m_Engine;
  const std::vector<std::uint64_t> & m_Steps;
  std::size_t                        m_Next{ 0 };
};

std::uint64_t
HeatDiffusionSolver::Run(PaddedField &                      heat,
                         std::uint64_t                      lastStep,
                         const std::vector<std::uint64_t> & steps,
                         const Visitor &                    visitor)
{
  VisitedSnapshots snapshots(visitor);
  return this->Run(heat, lastStep, steps, snapshots);
}

std::uint64_t
HeatDiffusionSolver::Run(PaddedField &                      heat,
                         std::uint64_t                      lastStep,
                         const std::vector<std::uint64_t> & steps,
                         HeatSnapshots &                    snapshots)
{
  const bool ascend = std::adjacent_find(steps.begin(), steps.end(), std::greater_equal<>()) == steps.end();
  if (!ascend || (!steps.empty() && steps.back() > lastStep))
  {
    throw std::invalid_argument("the steps to record must be ascending and must not exceed the last step");
  }
  m_Steady = false;
  m_Applications = 0;
  const auto report = [this] { this->ReportProgress(0.0); };
  m_DeviceUse = ChooseDeviceForHeat(m_Device, m_VolumeGradient.GetGrid());
  const std::unique_ptr<HeatEngine> engine =
    m_DeviceUse.gpu
      ? MakeHeatEngineOnGpu(m_DeviceUse, m_VolumeGradient, heat, snapshots, report)
      : std::unique_ptr<HeatEngine>(std::make_unique<HeatEngineOnCpu>(m_VolumeGradient, heat, snapshots, report));
  Recorder recorder(*engine, steps);
  recorder.Show(HeatEngine::Heat, 0);
  const std::uint64_t reached = m_Method == Method::Explicit ? this->RunExplicitly(*engine, lastStep, recorder)
                                                             : this->RunByExpansion(*engine, lastStep, steps, recorder);
  engine->Finish();
  return reached;
}

std::uint64_t
HeatDiffusionSolver::RunExplicitly(HeatEngine & engine, std::uint64_t lastStep, Recorder & recorder)
{
  constexpr HeatEngine::Field before = HeatEngine::Difference; // not needed by explicit steps
  m_PlannedApplications = static_cast<double>(lastStep);
  std::uint64_t step = 0;
  while (step < lastStep && !m_Steady)
  {
    // Intervals of the time ratio, for the steady check.
    const auto end =
      m_StopWhenSteady
        ? std::min(lastStep, std::max(explicitStart, static_cast<std::uint64_t>(std::ceil(step * intervalRatio))))
        : lastStep;
    const std::uint64_t start = step;
    const bool          check = m_StopWhenSteady && start > 0;
    if (check)
    {
      engine.Copy(HeatEngine::Heat, before);
    }
    while (step < end)
    {
      const std::uint64_t next = recorder.Next(end);
      this->Advance(engine, next - step, Sums::Compensated);
      step = next;
      recorder.Show(HeatEngine::Heat, step);
    }
    m_Steady = check && end >= intervalRatio * start &&
               IsSteadyBetween(engine, m_VolumeGradient.GetNumberOfVoxels(), before, HeatEngine::Heat, m_SteadyRule);
  }
  return step;
}

std::uint64_t
HeatDiffusionSolver::RunByExpansion(HeatEngine &                       engine,
                                    std::uint64_t                      lastStep,
                                    const std::vector<std::uint64_t> & steps,
                                    Recorder &                         recorder)
{
  const bool    dense = m_StopWhenSteady || steps.size() >= NumberOfNodes;
  std::uint64_t step = 0;
  const auto    start = dense ? std::min(explicitStart, lastStep) : 0;
  const auto    plan = PlanIntervals(start, lastStep, steps, m_StopWhenSteady);
  const auto    expansions = this->PlanExpansions(start, plan);

  while (step < start)
  {
    const std::uint64_t next = recorder.Next(start);
    this->Advance(engine, next - step, Sums::Plain);
    step = next;
    recorder.Show(HeatEngine::Heat, step);
  }
  for (std::size_t i = 0; i < plan.size() && !m_Steady; ++i)
  {
    this->Expand(engine, expansions[i]);
    this->ShowNodes(engine, plan[i], recorder);
    const auto last = HeatEngine::FirstNode + static_cast<HeatEngine::Field>(plan[i].nodes.size()) - 1;
    // A truncated last interval is too short for the check.
    m_Steady = m_StopWhenSteady && plan[i].end >= intervalRatio * plan[i].start &&
               IsSteadyBetween(engine, m_VolumeGradient.GetNumberOfVoxels(), HeatEngine::Heat, last, m_SteadyRule);
    engine.Exchange(HeatEngine::Heat, last);
    step = plan[i].end;
  }
  return step;
}

void
HeatDiffusionSolver::ShowNodes(HeatEngine & engine, const Interval & interval, Recorder & recorder)
{
  for (std::size_t k = 0; k < interval.nodes.size(); ++k)
  {
    engine.ClampToZero(HeatEngine::FirstNode + static_cast<HeatEngine::Field>(k));
  }
  if (interval.interpolate)
  {
    recorder.ShowInterpolated(interval, [this] { this->ReportProgress(0.0); });
    return;
  }
  for (std::size_t k = 0; k < interval.nodes.size(); ++k)
  {
    recorder.Show(HeatEngine::FirstNode + static_cast<HeatEngine::Field>(k), interval.nodes[k]);
    this->ReportProgress(0.0); // passes on complete volumes
  }
}

std::vector<HeatDiffusionSolver::Expansions>
HeatDiffusionSolver::PlanExpansions(std::uint64_t explicitSteps, const std::vector<Interval> & plan)
{
  const double            beta = std::min(1.0, m_TimeStepLength * m_VolumeGradient.GetEigenvalueBound());
  const double            truncation = 0.02 * m_Tolerance; // most of the tolerance is reserved for rounding
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
