#ifndef shapetonSparseAssignment_h
#define shapetonSparseAssignment_h

#include <vector>

namespace shapeton
{
/** Assignment with dustbins: rows may go to columns for a cost, or stay alone. */
struct AssignmentProblem
{
  struct Candidate
  {
    int    column;
    double cost;
  };
  /** Of each row. */
  std::vector<std::vector<Candidate>> candidates;
  /** Of each row and column that stays alone. */
  std::vector<double> rowAlone;
  std::vector<double> columnAlone;
};

struct Assignment
{
  /** The number of the candidate that each row takes, or -1. */
  std::vector<int> choice;
  double           cost{ 0.0 };
};

/** The cheapest assignment in which no column is taken twice: Hungarian method (Kuhn 1955) by shortest augmenting paths
 * on the candidates alone. Each row has its own dustbin, so that a path always exists. */
Assignment
SolveAssignment(const AssignmentProblem & problem);
} // namespace shapeton

#endif
