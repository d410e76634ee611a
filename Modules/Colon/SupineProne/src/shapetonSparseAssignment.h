#ifndef shapetonSparseAssignment_h
#define shapetonSparseAssignment_h

#include <vector>

namespace shapeton
{
/** Assignment problem with dustbins: rows are assigned to columns at a cost or remain unassigned. */
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
  /** Candidate index of each row, or -1. */
  std::vector<int> choice;
  double           cost{ 0.0 };
};

/** The one-to-one assignment of minimum cost by the Hungarian method (Kuhn 1955), with shortest augmenting paths over
 * the candidates only. Each row has a dustbin, so a path always exists. */
Assignment
SolveAssignment(const AssignmentProblem & problem);
} // namespace shapeton

#endif
