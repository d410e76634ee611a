#ifndef shapetonHeatDiffusionSolver_h
#define shapetonHeatDiffusionSolver_h

#include "shapetonDevice.h"
#include "shapetonHeatSnapshots.h"
#include "shapetonProgress.h"
#include "shapetonVolumeGradientOperator.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace shapeton
{
class HeatEngine;

/** \class HeatDiffusionSolver
 * \brief Performs time steps f_i += dt * sum_j c_ij (f_j - f_i) of a VolumeGradientOperator.
 *
 * Chebyshev (default): t steps are the polynomial (1 - dt L)^t of the operator L. On [0, lambda_max] a Chebyshev
 * expansion of degree about sqrt(t dt lambda_max ln(2 / tolerance)) equals it within the tolerance; t = 100,000 takes
 * about 1,100 applications of L. The difference form of the recurrence keeps the single-precision rounding error near
 * 3e-6, compared to 1e-4 for t explicit steps. Explicit: single steps with compensated (Kahan) sums.
 *
 * Intermediate fields are cheap and never change the last: the time is divided into intervals with an end / start ratio
 * of at most 32. One Chebyshev pass computes the fields at 13 nodes, and any field between them is a combination of
 * these (error below 2e-6 for every decay rate). Histograms between the nodes count every n-th slice of more than 2^22
 * voxels, which stands for n slices. Early steps, before the end of the first interval, are computed by themselves.
 *
 * Results are bitwise identical for any number of threads, on every x86-64 CPU and on a GPU.
 *
 * \equation{2.1} with the sign of the forward heat equation.
 *
 * \ingroup ShapetonHeat */
class ShapetonHeat_EXPORT HeatDiffusionSolver
{
public:
  enum class Method
  {
    Chebyshev,
    Explicit
  };

  /** The largest allowed time step. Stability requires at most 1/6 on a cubic grid, but at 1/6 checkerboard modes decay
   * as slowly as smooth ones. */
  static constexpr double MaximumTimeStepLength = 1.0 / 12.0;

  /** `timeStepLength` dt in (0, 1/12]; `tolerance` of the heat, in [1e-6, 1]; throws ParameterError. The
   * operator must outlive the solver. */
  HeatDiffusionSolver(const VolumeGradientOperator & volumeGradient,
                      Method                         method,
                      double                         timeStepLength,
                      double                         tolerance);

  /** Receives row `row` = y + ny * z of the heat after steps[snapshot]. Called concurrently; `worker` identifies the
   * thread and is less than the number of ITK's threads. */
  using Visitor = std::function<void(std::size_t snapshot, std::size_t row, const float * heat, unsigned int worker)>;

  /** Receives the progress in [0, 1] on the calling thread; may throw to abort. */
  void
  SetProgress(Progress progress)
  {
    m_Progress = std::move(progress);
  }

  /** Device that computes the heat; default: the CPU. A requested GPU that does not have enough memory for the volume
   * processes it in slabs. */
  void
  SetDevice(Device device)
  {
    m_Device = device;
  }
  /** The device used by the last Run. */
  const DeviceUse &
  GetDeviceUse() const
  {
    return m_DeviceUse;
  }

  /** Stops when the heat is steady: over a time interval with an end / start ratio of 2.5, at most a fraction `voxels`
   * of all voxels changes by more than `change` times their heat, or `change` times `leastHeat` if they are colder. Off
   * by default. */
  struct SteadyRule
  {
    double change{ 0.01 };
    double voxels{ 0.001 };
    double leastHeat{ 0.001 };
  };
  void
  StopWhenSteady(const SteadyRule & rule)
  {
    m_StopWhenSteady = true;
    m_SteadyRule = rule;
  }

  /** Advances `heat` from step 0 to `lastStep`, or to the step at which it is steady. Calls the visitor with the
   * heat after each of `steps` (ascending, none beyond `lastStep`; steps not reached are omitted). Returns the last
   * step. Throws DeviceError if the device cannot be used. */
  std::uint64_t
  Run(PaddedField &                      heat,
      std::uint64_t                      lastStep,
      const std::vector<std::uint64_t> & steps = {},
      const Visitor &                    visitor = {});
  std::uint64_t
  Run(PaddedField & heat, std::uint64_t lastStep, const std::vector<std::uint64_t> & steps, HeatSnapshots & snapshots);

  /** True if the last Run ended because the heat was steady. */
  bool
  IsSteady() const
  {
    return m_Steady;
  }

  /** Number of applications of the operator in the last Run. */
  std::uint64_t
  GetNumberOfApplications() const
  {
    return m_Applications;
  }

  /** Coefficients c_k, k = 0, 1, ..., of (1 - beta (1 - x) / 2)^steps = sum c_k T_k(x) on [-1, 1], truncated when
   * the remainder is below `tolerance`; beta = dt lambda_max in (0, 1]. */
  static std::vector<double>
  ChebyshevCoefficients(std::uint64_t steps, double beta, double tolerance);

private:
  class Recorder;
  struct Interval;
  using Expansions = std::vector<std::vector<double>>; // coefficients for each node of an interval

  enum class Intervals
  {
    Short, ///< an end / start ratio of 2.5, from a start after explicit steps
    Long   ///< of at most 32
  };
  std::vector<Interval>
  PlanIntervals(std::uint64_t start, std::uint64_t last, const Recorder & recorder, Intervals length) const;
  std::vector<Expansions>
  PlanExpansions(std::uint64_t explicitSteps, const std::vector<Interval> & plan);

  std::uint64_t
  RunExplicitly(HeatEngine & engine, std::uint64_t lastStep, Recorder & recorder);
  std::uint64_t
  RunByExpansion(HeatEngine & engine, std::uint64_t lastStep, Recorder & recorder);
  void
  RunFirstSteps(HeatEngine & engine, std::uint64_t lastStep, Recorder & recorder);
  std::uint64_t
  RunIntervals(HeatEngine &                    engine,
               const std::vector<Interval> &   plan,
               const std::vector<Expansions> & expansions,
               Recorder &                      recorder);
  /** Shows the requested steps before `end`, then returns to the initial heat. */
  void
  ShowEarlySteps(HeatEngine & engine, std::uint64_t end, Recorder & recorder);
  /** Passes the requested steps of an interval to the visitor, interpolated from its nodes. */
  void
  ShowNodes(HeatEngine & engine, const Interval & interval, Recorder & recorder);

  /** Whether explicit steps compensate rounding errors; not needed for a few steps. */
  enum class Sums
  {
    Plain,
    Compensated
  };
  /** Advances the heat by explicit steps. */
  void
  Advance(HeatEngine & engine, std::uint64_t steps, Sums sums);
  /** Node g = sum_k coefficients[g][k] T_k(X) heat, X the operator mapped to [-1, 1]. */
  void
  Expand(HeatEngine & engine, const Expansions & coefficients, std::size_t stride);
  void
  ReportProgress(double applications);

  const VolumeGradientOperator & m_VolumeGradient;
  Method                         m_Method;
  double                         m_TimeStepLength;
  double                         m_Tolerance;
  Progress                       m_Progress;
  Device                         m_Device{ Device::Cpu };
  DeviceUse                      m_DeviceUse;
  bool                           m_StopWhenSteady{ false };
  SteadyRule                     m_SteadyRule;
  bool                           m_Steady{ false };
  std::uint64_t                  m_Applications{ 0 };
  double                         m_PlannedApplications{ 1.0 };
};
} // namespace shapeton

#endif
