#ifndef shapetonHeatMultigrid_h
#define shapetonHeatMultigrid_h

#include "shapetonConductanceGraph.h"
#include "shapetonProgress.h"

#include <memory>
#include <vector>

namespace shapeton
{
/** A conductance field and its coarser levels. */
class ConductanceHierarchy
{
public:
  ConductanceHierarchy(const VolumeGradientOperator & volumeGradient,
                       const unsigned short *         seeds,
                       const unsigned short *         before,
                       const Progress &               progress);

  const ConductanceField &
  GetFinest() const
  {
    return m_Finest;
  }
  const std::vector<ConductanceGraph> &
  GetGraphs() const
  {
    return m_Graphs;
  }
  /** Entry 0: the aggregates of the finest level; entry k + 1: the aggregates of graph k. */
  const std::vector<std::vector<std::uint32_t>> &
  GetAggregates() const
  {
    return m_Aggregates;
  }

private:
  ConductanceField                        m_Finest;
  std::vector<ConductanceGraph>           m_Graphs;
  std::vector<std::vector<std::uint32_t>> m_Aggregates;
};

/** Values of several labels per node, interleaved: one pass over memory processes all labels. */
class LabelField
{
public:
  /** Initially 0. */
  explicit LabelField(std::size_t length);

  float *
  GetData()
  {
    return m_Values.get();
  }
  const float *
  GetData() const
  {
    return m_Values.get();
  }
  std::size_t
  GetLength() const
  {
    return m_Length;
  }
  void
  Clear();

private:
  std::unique_ptr<float[]> m_Values;
  std::size_t              m_Length;
};

/** Conjugate gradients for the potentials of `VLabels` labels at once, preconditioned by a multigrid cycle with
 * conductance-based aggregates (Notay, Electronic Transactions on Numerical Analysis 37, 2010). Gauss-Seidel sweeps
 * process alternating slabs of slices, so results do not depend on the number of threads. Coefficients are computed per
 * label. */
template <int VLabels>
class HeatMultigrid
{
public:
  explicit HeatMultigrid(const ConductanceHierarchy & hierarchy);

  /** Iterates on `potentials` until no correction of the preconditioner, an estimate of the error, exceeds `tolerance`.
   * `residuals` contains the residuals of the start values and is overwritten. Returns the number of iterations. */
  unsigned int
  Solve(LabelField & potentials, LabelField & residuals, double tolerance, const Progress & progress);

  /** residuals -= A potentials. */
  void
  SubtractImage(const LabelField & potentials, LabelField & residuals) const;

private:
  using Sums = std::array<double, VLabels>;
  using Factors = std::array<float, VLabels>;
  struct Measure
  {
    Sums  products; ///< dot products of residuals and corrections
    float greatest; ///< largest correction
  };

  // StepAndSweep(), SweepBack() and Advance() make one pass through memory each; these passes dominate the run time for
  // large volumes.

  /** Subtracts `step` times the corrections (the images of the directions) from the residuals, then computes the
   * corrections for the new residuals. */
  Measure
  Precondition(const Factors & step, float * residuals, float * corrections);
  /** First part of the cycle, including the forward sweep, which starts from 0. */
  void
  StepAndSweep(const Factors & step, float * residuals, float * corrections) const;
  /** Last part of the cycle. */
  Measure
  SweepBack(const float * residuals, float * corrections) const;
  /** Adds `step` times the directions to the potentials; directions become corrections + `share` * directions;
   * corrections become the images of the directions. Returns the products of directions and images. */
  Sums
  Advance(const Factors & step, const Factors & share, float * potentials, float * directions, float * corrections)
    const;
  void
  CycleGraph(std::size_t level);
  void
  SweepGraph(std::size_t level, bool forward);
  void
  RestrictFromField(const float * values);
  void
  RestrictFromGraph(std::size_t level);
  void
  ProlongToField(float * values) const;
  void
  ProlongToGraph(std::size_t level);

  const ConductanceHierarchy & m_Hierarchy;
  std::vector<LabelField>      m_Residuals; ///< of each graph
  std::vector<LabelField>      m_Values;
};

extern template class HeatMultigrid<1>;
extern template class HeatMultigrid<2>;
extern template class HeatMultigrid<4>;
} // namespace shapeton

#endif
