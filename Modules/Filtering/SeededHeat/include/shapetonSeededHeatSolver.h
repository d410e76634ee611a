#ifndef shapetonSeededHeatSolver_h
#define shapetonSeededHeatSolver_h

#include "SeededHeatExport.h"
#include "shapetonProgress.h"
#include "shapetonRemarks.h"
#include "shapetonVolumeGradientOperator.h"

#include <memory>
#include <vector>

namespace shapeton
{
/** \class SeededHeatSettings
 * \brief How seeded heat is solved.
 * \ingroup SeededHeat */
struct SeededHeatSettings
{
  /** Greatest error of a probability, as the solver estimates it; in [1e-6, 0.1]. */
  double tolerance{ 1e-5 };
  /** Keep the probabilities of all labels, four bytes for each voxel and label but one: for GetProbabilities(), and for
   * a solution that starts from the last one. */
  bool keepProbabilities{ true };
};

/** \class SeededHeatResult
 * \brief What SeededHeatSolver finds; one entry for each voxel, x fastest.
 * \ingroup SeededHeat */
struct SeededHeatResult
{
  /** The label of greatest probability, the lowest one of equals. */
  std::vector<unsigned short> labels;
  /** 1 minus the difference of the two greatest probabilities: 0 where one label is sure, 1 where two are equal. */
  std::vector<float> uncertainty;
  /** The labels that have seeds, ascending. */
  std::vector<unsigned short> labelValues;
  /** Of the conjugate gradients, at most. */
  unsigned int iterations{ 0 };
  /** Labels that hardly leave their seeds: where half of the voxels or more have no seed, those that get fewer than
   * FewestVoxels of them. A point alone is such a seed where nothing holds its heat back. */
  Remarks remarks;

  /** 5^3: a part of this size takes fewer strokes to paint than to seed. */
  static constexpr std::size_t FewestVoxels = 125;
};

/** \class SeededHeatSolver
 * \brief The steady state of heat that leaves the seeds of each label, on the conductances of a VolumeGradientOperator.
 *
 * The seeds of a label are held at heat 1, all other seeds at 0; no heat leaves the volume. In the steady state each
 * voxel has for each label l the heat
 *
 *   sum_j c_ij (f_l(i) - f_l(j)) = 0,
 *
 * which is the probability that a walker who steps from i over its edges in proportion to their conductances meets a
 * seed of l first: Grady, Random walks for image segmentation, IEEE TPAMI 28 (2006), with the weights of (2.5). The
 * probabilities of all labels sum to 1; where there are two, their boundary is at one half.
 *
 * Solved in single precision by conjugate gradients with a multigrid preconditioner, without a matrix on the finest
 * level, for up to four labels in one pass over memory. The same bytes for any number of threads. Memory, beside the
 * operator: 16 bytes for each voxel, 16 for each voxel and label of a pass, and a third more for the coarse levels.
 *
 * \ingroup SeededHeat */
class SeededHeat_EXPORT SeededHeatSolver
{
public:
  /** The operator must outlive the solver. Throws ParameterError for settings out of range. */
  explicit SeededHeatSolver(const VolumeGradientOperator & volumeGradient, const SeededHeatSettings & settings = {});
  ~SeededHeatSolver();

  /** `seeds`: the label of each voxel, 0 for none, x fastest. With kept probabilities and the labels of the call
   * before, the solution starts from the last one: few changed seeds take few iterations. Throws InputError where fewer
   * than two labels have seeds, or a volume is too large (2^32 places); `progress` may throw to abort, and the next
   * call starts anew. */
  const SeededHeatResult &
  Solve(const unsigned short * seeds, const Progress & progress = {});

  const SeededHeatResult &
  GetResult() const
  {
    return m_Result;
  }

  /** The probability of a label in each voxel, in [0, 1]; those of all labels sum to 1 but for rounding. Throws
   * ParameterError where probabilities were not kept or the label has no seed. */
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
  void
  Finish();
  void
  RemarkOnFewVoxels(const unsigned short * seeds);

  const VolumeGradientOperator & m_VolumeGradient;
  SeededHeatSettings             m_Settings;
  SeededHeatResult               m_Result;
  std::vector<Batch>             m_Batches;
  std::vector<float>             m_Best;
  std::vector<float>             m_Second;
  std::vector<float>             m_Sum; ///< of the labels that were solved for: all but the last one
};
} // namespace shapeton

#endif
