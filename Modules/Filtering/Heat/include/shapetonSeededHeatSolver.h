#ifndef shapetonSeededHeatSolver_h
#define shapetonSeededHeatSolver_h

#include "ShapetonHeatExport.h"
#include "shapetonProgress.h"
#include "shapetonRemarks.h"
#include "shapetonSeededHeatOptions.h"
#include "shapetonVolumeGradientOperator.h"

#include <vector>

namespace shapeton
{
/** \class SeededHeatResult
 * \brief Result of SeededHeatSolver; one entry per voxel, x fastest.
 * \ingroup ShapetonHeat */
struct SeededHeatResult
{
  /** The most probable label; the lowest one for ties; 0 for voxels that no heat reaches, outside the domain of the
   * volume or in a part of it without a seed. */
  std::vector<unsigned short> labels;
  /** 1 minus the difference between the two greatest probabilities: 0 for a certain label, 1 for a tie. */
  std::vector<float> uncertainty;
  /** The labels that have seeds, ascending. */
  std::vector<unsigned short> labelValues;
  /** Largest number of conjugate gradient iterations. */
  unsigned int iterations{ 0 };
  /** Remarks on labels that hardly grow beyond their seeds: they gain fewer than FewestVoxels voxels, although at least
   * half of all voxels have no seed. This happens for an isolated point without edges that confine its heat. */
  Remarks remarks;

  /** 5^3: painting a smaller part takes fewer strokes than seeding it. */
  static constexpr std::size_t FewestVoxels = 125;
};

/** \class SeededHeatSolver
 * \brief Steady state of heat diffusion from the seeds of each label, on the conductances of a VolumeGradientOperator.
 *
 * The seeds of a label are held at heat 1, all other seeds at 0; no heat leaves the volume. In the steady state the
 * heat f_l of each label l satisfies at each voxel i without a seed
 *
 *   sum_j c_ij (f_l(i) - f_l(j)) = 0,
 *
 * and f_l(i) is the probability that a random walker from i, with transition probabilities proportional to the
 * conductances, reaches a seed of l first: Grady, Random walks for image segmentation, IEEE TPAMI 28 (2006), with the
 * weights of (2.5). The probabilities of all labels sum to 1; for two labels, their boundary is at one half.
 *
 * Solved in single precision by conjugate gradients with a multigrid preconditioner, matrix-free on the finest level,
 * for up to four labels in one pass over memory. Results are bitwise identical for any number of threads. Memory in
 * addition to the operator: 16 bytes per voxel, 16 per voxel and label of a pass, and a third more for the coarse
 * levels.
 *
 * \ingroup ShapetonHeat */
class ShapetonHeat_EXPORT SeededHeatSolver
{
public:
  /** Within a region without edges, seeds then change labels up to about 1 / sqrt(0.001) = 30 voxels away, which is
   * about the radius of the parts that are corrected. */
  static constexpr float ConductanceToLabelBefore = 1e-3F;

  /** The operator must outlive the solver. Throws ParameterError for settings out of range. */
  explicit SeededHeatSolver(const VolumeGradientOperator & volumeGradient, const SeededHeatOptions & settings = {});
  ~SeededHeatSolver();

  /** `seeds`: the label of each voxel, 0 for none, x fastest. With kept probabilities and the labels of the previous
   * call, the solver starts from the last solution: a few changed seeds then take few iterations. Seeds outside the
   * domain have no effect. Throws InputError
   * if there are fewer than two labels, or the volume is too large (2^32 voxels with padding). `progress` may
   * throw to abort; the next call then starts from scratch. With labels `before` (0: none; null: none at all), seeds
   * correct them: each voxel has an edge of ConductanceToLabelBefore to its label before, as in random walks with
   * priors (Grady, CVPR 2005), so far from seeds and behind edges, it keeps this label. */
  const SeededHeatResult &
  Solve(const unsigned short * seeds, const Progress & progress = {}, const unsigned short * before = nullptr);

  const SeededHeatResult &
  GetResult() const
  {
    return m_Result;
  }

  /** The probability of a label in each voxel, in [0, 1]; the probabilities of all labels sum to 1 up to rounding.
   * Throws ParameterError if probabilities were not kept or the label has no seed. */
  void
  GetProbabilities(unsigned short label, float * probabilities) const;

private:
  struct Batch;
  template <int VLabels>
  void
  SolveBatch(Batch &                            batch,
             const unsigned short *             seeds,
             const class ConductanceHierarchy & hierarchy,
             const Progress &);
  void
  SetSeedValues(Batch & batch, const unsigned short * seeds) const;
  void
  Compare(const Batch & batch);
  const SeededHeatResult &
  SolveInDomain(const unsigned short * seeds, const unsigned short * before, const Progress & progress);
  void
  ExcludeUnreached(const unsigned short * seeds, const unsigned short * before);
  void
  Finish();
  void
  RemarkOnFewVoxels(const unsigned short * seeds);

  const VolumeGradientOperator & m_VolumeGradient;
  SeededHeatOptions              m_Settings;
  SeededHeatResult               m_Result;
  std::vector<Batch>             m_Batches;
  std::vector<float>             m_Best;
  std::vector<float>             m_Second;
  std::vector<float>             m_Sum; ///< for all solved labels, that is all except the last one
};
} // namespace shapeton

#endif
