#ifndef shapetonSparseAssignment_h
#define shapetonSparseAssignment_h

#include <vector>

namespace shapeton
{
/** Assignment with dustbins: rows are assigned to columns at a cost, or stay unassigned. */
struct AssignmentProblem
{
  struct Candidate
  {
    int    column;
    double cost;
  };
  /** Candidates of each row. */
  std::vector<std::vector<Candidate>> candidates;
  /** Cost of each unassigned row and column. */
  std::vector<double> rowAlone;
  std::vector<double> columnAlone;
};

struct Assignment
{
  /** Index of the candidate chosen by each row, or -1. */
  std::vector<int> choice;
  double           cost{ 0.0 };
};

/** The cheapest one-to-one assignment: Hungarian method (Kuhn 1955) by shortest augmenting paths over the candidates
 * only. Each row has its own dustbin, so a path always exists. */
Assignment
SolveAssignment(const AssignmentProblem & problem);
} // namespace shapeton

#endif
