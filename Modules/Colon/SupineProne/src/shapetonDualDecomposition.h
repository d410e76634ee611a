#ifndef shapetonDualDecomposition_h
#define shapetonDualDecomposition_h

#include "shapetonSparseAssignment.h"

#include <Eigen/Core>

namespace shapeton
{
/** Two rows of an assignment with dependent choices; the last label of a row is its dustbin. */
struct PairTerm
{
  int             first;
  int             second;
  Eigen::MatrixXd cost; ///< label of the first, label of the second
};

struct PairedAssignment
{
  Assignment assignment; ///< its cost includes that of the pairs
  double     bound{ 0.0 };
  int        iterations{ 0 };
};

/** Minimizes assignment and pair terms by dual decomposition. Deterministic; stops early when the bound is reached. */
PairedAssignment
SolvePairedAssignment(const AssignmentProblem & problem, const std::vector<PairTerm> & pairs, int iterations);
} // namespace shapeton

#endif
