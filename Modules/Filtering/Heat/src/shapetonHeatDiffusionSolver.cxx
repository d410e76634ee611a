#include "shapetonHeatDiffusionSolver.h"
#include "shapetonExceptions.h"
#include "shapetonHeatEngineOnCpu.h"
#include "shapetonHeatEngineOnGpu.h"
#include "shapetonHeatInterpolation.h"
#include "shapetonParallelFor.h"
#include "shapetonPi.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>

namespace shapeton
{
/** A time interval with fields at its nodes. Requested steps are nodes or interpolated. */
struct HeatDiffusionSolver::Interval
{
  std::uint64_t              start;
  std::uint64_t              end;
  std::size_t                firstSnapshot; // the number of requested steps up to the start
  std::size_t                endSnapshot;   // and up to the end
  std::vector<std::uint64_t> nodes;         // excluding the start
  bool                       interpolate;
  std::size_t                stride; // see HeatEngine::SliceStride
};

namespace
{
// Interpolation in intervals up to either end / start ratio has an error below 2e-6; see HeatInterpolation.
constexpr double      intervalRatio = 2.5;
constexpr std::size_t nodesOfInterval = 7;
constexpr std::size_t nodesOfLongInterval = HeatEngine::MostNodes;
// This many requested steps of an interval are its nodes; more are interpolated.
constexpr std::size_t   few = nodesOfInterval - 1;
constexpr std::uint64_t explicitStart = 16;

// A long time interval is split if its end / start ratio would exceed this: rounding errors grow with the degree of an
// expansion and with the fine detail of its initial field, which earlier intervals smooth out.
constexpr std::uint64_t longestRatio = 32;
constexpr std::uint64_t shortestStretch = 1000;

/** Between the nodes, histograms of larger volumes count every n-th slice, at least 2^21 voxels and 16 slices: the
 * number in a bin of a thousandth of them has a standard deviation of 2 % if voxels are independent. */
std::size_t
StrideForCounts(const PaddedGrid & grid)
{
  constexpr std::size_t enoughVoxels = std::size_t{ 1 } << 21;
  constexpr std::size_t enoughSlices = 16;
  return std::clamp<std::size_t>(
    grid.GetNumberOfVoxels() / enoughVoxels, 1, std::max<std::size_t>(1, grid.GetSize()[2] / enoughSlices));
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

/** Passes the heat after each requested step to the snapshots. */
class HeatDiffusionSolver::Recorder
{
public:
  Recorder(HeatEngine & engine, HeatSnapshots & snapshots, const std::vector<std::uint64_t> & steps)
    : m_Engine(engine), m_Snapshots(snapshots), m_Steps(steps)
  {}

  const std::vector<std::uint64_t> &
  GetSteps() const
  {
    return m_Steps;
  }

  /** Whether all requested steps from number `first` to `end` are counted in histograms only. */
  bool
  OnlyCounts(std::size_t first, std::size_t end) const
  {
    for (; first < end && !m_Snapshots.IsShown(first); ++first)
    {}
    return first >= end;
  }

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
    std::vector<std::uint64_t> steps{ interval.start };
    steps.insert(steps.end(), interval.nodes.begin(), interval.nodes.end());
    const HeatInterpolation                              interpolation(steps);
    std::array<HeatEngine::Field, HeatEngine::MostNodes> nodes{}; // the heat of the start, also for nodes of weight 0
    std::iota(nodes.begin() + 1, nodes.begin() + steps.size(), HeatEngine::FirstNode);
    const std::size_t between = interval.endSnapshot - (m_Steps[interval.endSnapshot - 1] == interval.end ? 1 : 0);
    while (m_Next < between)
    {
      const std::size_t                end = std::min(m_Next + snapshotsAtOnce, between);
      std::vector<HeatEngine::Weights> weights;
      for (std::size_t snapshot = m_Next; snapshot < end; ++snapshot)
      {
        const std::vector<double> exact = interpolation.WeightsAt(m_Steps[snapshot]);
        HeatEngine::Weights       rounded{};
        std::transform(
          exact.begin(), exact.end(), rounded.begin(), [](double weight) { return static_cast<float>(weight); });
        weights.push_back(rounded);
      }
      m_Engine.ShowCombined(m_Next, nodes, weights, interval.stride);
      m_Next = end;
      afterGroup();
    }
    this->Show(nodes[steps.size() - 1], interval.end);
  }

private:
  // Collected volumes are complete after each group, which limits memory.
  static constexpr std::size_t snapshotsAtOnce = 4;

  HeatEngine &                       m_Engine;
  const HeatSnapshots &              m_Snapshots;
  const std::vector<std::uint64_t> & m_Steps;
  std::size_t                        m_Next{ 0 };
};

std::vector<HeatDiffusionSolver::Interval>
HeatDiffusionSolver::PlanIntervals(std::uint64_t    start,
                                   std::uint64_t    last,
                                   const Recorder & recorder,
                                   Intervals        length) const
{
  const auto &          steps = recorder.GetSteps();
  std::vector<Interval> plan;
  std::size_t           snapshot = std::upper_bound(steps.begin(), steps.end(), start) - steps.begin();
  while (start < last)
  {
    std::uint64_t end = last;
    if (length == Intervals::Short)
    {
      end = std::min(last, static_cast<std::uint64_t>(std::ceil(start * intervalRatio)));
    }
    while (length == Intervals::Long && end > shortestStretch && end > longestRatio * start)
    {
      end = (end + longestRatio - 1) / longestRatio;
    }
    Interval interval{ start, std::max(end, start + 1), snapshot, snapshot, {}, false, 1 };
    interval.endSnapshot = std::upper_bound(steps.begin(), steps.end(), interval.end) - steps.begin();
    interval.interpolate = interval.endSnapshot - snapshot > few && start > 0;
    if (interval.interpolate)
    {
      const bool isShort = static_cast<double>(interval.end) <= std::ceil(intervalRatio * start);
      interval.nodes =
        HeatInterpolation::ChooseNodes(start, interval.end, isShort ? nodesOfInterval : nodesOfLongInterval);
      interval.nodes.erase(interval.nodes.begin());
      const bool counts = recorder.OnlyCounts(snapshot, interval.endSnapshot);
      interval.stride = counts ? StrideForCounts(m_VolumeGradient.GetGrid()) : 1;
    }
    else if (interval.endSnapshot - snapshot <= few)
    {
      interval.nodes.assign(steps.begin() + snapshot, steps.begin() + interval.endSnapshot);
    }
    if (interval.nodes.empty() || interval.nodes.back() != interval.end)
    {
      interval.nodes.push_back(interval.end);
    }
    start = interval.end;
    snapshot = interval.endSnapshot;
    plan.push_back(interval);
  }
  return plan;
}

HeatDiffusionSolver::HeatDiffusionSolver(const VolumeGradientOperator & volumeGradient,
                                         Method                         method,
                                         double                         timeStepLength,
                                         double                         tolerance)
  : m_VolumeGradient(volumeGradient), m_Method(method), m_TimeStepLength(timeStepLength), m_Tolerance(tolerance)
{
  constexpr double rounding = 1e-6; // accepts 0.08333333 as 1/12
  constexpr double leastTolerance = 1e-6;
  RequireParameter(timeStepLength > 0.0 && timeStepLength <= MaximumTimeStepLength * (1.0 + rounding),
                   "the time step must be positive and at most 1/12");
  RequireParameter(tolerance >= leastTolerance && tolerance <= 1.0, "the tolerance must be between 1e-6 and 1");
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
  while (steps > 0)
  {
    const auto count = static_cast<unsigned int>(std::min<std::uint64_t>(steps, engine.GetLongestStretch(false)));
    engine.StepExplicitly(count, dt, sums == Sums::Compensated);
    steps -= count;
    this->ReportProgress(count);
  }
}

void
HeatDiffusionSolver::Expand(HeatEngine & engine, const Expansions & coefficients, std::size_t stride)
{
  const auto step = static_cast<float>(2.0 / m_VolumeGradient.GetEigenvalueBound());
  engine.Copy(HeatEngine::Heat, HeatEngine::Even);
  engine.Clear(HeatEngine::Difference);
  this->ReportProgress(0.0);
  std::size_t degree = 0;
  for (std::size_t g = 0; g < coefficients.size(); ++g)
  {
    const auto node = HeatEngine::FirstNode + static_cast<HeatEngine::Field>(g);
    const bool isLast = g + 1 == coefficients.size();
    engine.Scale(HeatEngine::Heat, node, static_cast<float>(coefficients[g][0]), isLast ? 1 : stride);
    degree = std::max(degree, coefficients[g].size() - 1);
  }
  const std::size_t longest = engine.GetLongestStretch(true);
  for (std::size_t done = 0; done < degree; done += longest)
  {
    // Makes the number of terms even, because they are added in pairs.
    const auto count = static_cast<unsigned int>(std::min(longest, (degree - done + 1) / 2 * 2));
    engine.StepChebyshev(done, count, 2.0F * step, coefficients, stride);
    this->ReportProgress(count);
  }
}

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
  RequireParameter(ascend && (steps.empty() || steps.back() <= lastStep),
                   "the steps to record must be ascending and must not exceed the last step");
  m_Steady = false;
  m_Applications = 0;
  const auto report = [this] { this->ReportProgress(0.0); };
  m_DeviceUse = ChooseDeviceForHeat(m_Device, m_VolumeGradient.GetGrid());
  const std::unique_ptr<HeatEngine> engine =
    m_DeviceUse.gpu
      ? MakeHeatEngineOnGpu(m_DeviceUse, m_VolumeGradient, heat, snapshots, report)
      : std::unique_ptr<HeatEngine>(std::make_unique<HeatEngineOnCpu>(m_VolumeGradient, heat, snapshots, report));
  Recorder recorder(*engine, snapshots, steps);
  recorder.Show(HeatEngine::Heat, 0);
  const std::uint64_t reached = m_Method == Method::Explicit ? this->RunExplicitly(*engine, lastStep, recorder)
                                                             : this->RunByExpansion(*engine, lastStep, recorder);
  engine->Finish();
  return reached;
}

std::uint64_t
HeatDiffusionSolver::RunExplicitly(HeatEngine & engine, std::uint64_t lastStep, Recorder & recorder)
{
  constexpr HeatEngine::Field before = HeatEngine::Difference; // not needed by explicit steps
  m_PlannedApplications = static_cast<double>(lastStep);
  engine.Clear(HeatEngine::Odd);
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

void
HeatDiffusionSolver::RunFirstSteps(HeatEngine & engine, std::uint64_t lastStep, Recorder & recorder)
{
  for (std::uint64_t step = 0; step < lastStep;)
  {
    const std::uint64_t next = recorder.Next(lastStep);
    this->Advance(engine, next - step, Sums::Plain);
    step = next;
    recorder.Show(HeatEngine::Heat, step);
  }
}

std::uint64_t
HeatDiffusionSolver::RunByExpansion(HeatEngine & engine, std::uint64_t lastStep, Recorder & recorder)
{
  m_PlannedApplications = 0.0;
  if (m_StopWhenSteady)
  {
    const std::uint64_t start = std::min(explicitStart, lastStep);
    const auto          plan = this->PlanIntervals(start, lastStep, recorder, Intervals::Short);
    const auto          expansions = this->PlanExpansions(start, plan);
    this->RunFirstSteps(engine, start, recorder);
    return std::max(start, this->RunIntervals(engine, plan, expansions, recorder));
  }
  // The requested steps do not change the intervals, and thereby not the heat.
  const auto plan = this->PlanIntervals(0, lastStep, recorder, Intervals::Long);
  const auto expansions = this->PlanExpansions(0, plan);
  if (!plan.empty() && plan.front().endSnapshot - plan.front().firstSnapshot > few)
  {
    this->ShowEarlySteps(engine, plan.front().end, recorder);
  }
  return this->RunIntervals(engine, plan, expansions, recorder);
}

void
HeatDiffusionSolver::ShowEarlySteps(HeatEngine & engine, std::uint64_t end, Recorder & recorder)
{
  constexpr HeatEngine::Field initial = HeatEngine::MostFields - 1; // not used in intervals of `Short` length
  const auto &                steps = recorder.GetSteps();
  const std::uint64_t         last = *std::prev(std::lower_bound(steps.begin(), steps.end(), end));
  const std::uint64_t         start = std::min(explicitStart, last);
  const auto                  plan = this->PlanIntervals(start, last, recorder, Intervals::Short);
  const auto                  expansions = this->PlanExpansions(start, plan);
  engine.Copy(HeatEngine::Heat, initial);
  this->RunFirstSteps(engine, start, recorder);
  this->RunIntervals(engine, plan, expansions, recorder);
  engine.Exchange(HeatEngine::Heat, initial);
}

std::uint64_t
HeatDiffusionSolver::RunIntervals(HeatEngine &                    engine,
                                  const std::vector<Interval> &   plan,
                                  const std::vector<Expansions> & expansions,
                                  Recorder &                      recorder)
{
  std::uint64_t step = 0;
  for (std::size_t i = 0; i < plan.size() && !m_Steady; ++i)
  {
    this->Expand(engine, expansions[i], plan[i].stride);
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
  const auto last = static_cast<HeatEngine::Field>(interval.nodes.size()) - 1;
  for (HeatEngine::Field k = 0; k <= last; ++k)
  {
    engine.ClampToZero(HeatEngine::FirstNode + k, k == last ? 1 : interval.stride);
  }
  if (interval.interpolate)
  {
    recorder.ShowInterpolated(interval, [this] { this->ReportProgress(0.0); });
    return;
  }
  for (HeatEngine::Field k = 0; k <= last; ++k)
  {
    recorder.Show(HeatEngine::FirstNode + k, interval.nodes[k]);
    this->ReportProgress(0.0); // passes on complete volumes
  }
}

std::vector<HeatDiffusionSolver::Expansions>
HeatDiffusionSolver::PlanExpansions(std::uint64_t explicitSteps, const std::vector<Interval> & plan)
{
  const double            beta = std::min(1.0, m_TimeStepLength * m_VolumeGradient.GetEigenvalueBound());
  const double            truncation = 0.02 * m_Tolerance; // most of the tolerance is reserved for rounding
  std::vector<Expansions> expansions;
  m_PlannedApplications += static_cast<double>(explicitSteps);
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
