#ifndef shapetonDualDecomposition_h
#define shapetonDualDecomposition_h

#include "shapetonSparseAssignment.h"

#include <Eigen/Core>

namespace shapeton
{
/** Pairwise term for two rows of an assignment; the last label of a row is its dustbin. */
struct PairTerm
{
  int             first;
  int             second;
  Eigen::MatrixXd cost; ///< indexed by label of the first and of the second row
};

struct PairedAssignment
{
  Assignment assignment; ///< with pairwise costs included
  double     bound{ 0.0 };
  int        iterations{ 0 };
};

/** Minimizes the sum of assignment and pair terms by dual decomposition. Deterministic; stops when the bound is
 * reached. */
PairedAssignment
SolvePairedAssignment(const AssignmentProblem & problem, const std::vector<PairTerm> & pairs, int iterations);
} // namespace shapeton

#endif
