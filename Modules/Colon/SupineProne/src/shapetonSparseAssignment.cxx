#include "shapetonSparseAssignment.h"

#include <functional>
#include <limits>
#include <numeric>
#include <queue>

namespace shapeton
{
namespace
{
/** Cost of a column to which no path is known. */
constexpr double unreached = std::numeric_limits<double>::infinity();

/** Columns with indices from m_Columns are the dustbins of the rows. */
class AugmentingPaths
{
public:
  explicit AugmentingPaths(const AssignmentProblem & problem)
    : m_Problem(problem), m_Columns(static_cast<int>(problem.columnAlone.size()))
  {
    const std::size_t rows = problem.candidates.size();
    m_RowOfColumn.assign(m_Columns + rows, -1);
    m_ChoiceOfColumn.assign(m_Columns + rows, -1);
    m_RowPotential.assign(rows, 0.0);
    m_ColumnPotential.assign(m_Columns + rows, 0.0);
  }

  /** Assigns a column to the row, along the shortest path in reduced costs (Dijkstra). */
  void
  Augment(int row)
  {
    m_Distance.assign(m_RowOfColumn.size(), unreached);
    m_From.assign(m_RowOfColumn.size(), -1);
    m_Through.assign(m_RowOfColumn.size(), -1);
    m_IsDone.assign(m_RowOfColumn.size(), 0);
    m_RowPotential[row] = this->LeastReducedCost(row);
    m_Queue = {};
    this->Relax(row, 0.0);
    int end = -1;
    while (end < 0)
    {
      const int column = m_Queue.top().second;
      m_Queue.pop();
      if (m_IsDone[column])
      {
        continue;
      }
      m_IsDone[column] = 1;
      if (m_RowOfColumn[column] < 0)
      {
        end = column;
      }
      else
      {
        this->Relax(m_RowOfColumn[column], m_Distance[column]);
      }
    }
    this->UpdatePotentials(row, m_Distance[end]);
    this->Flip(end);
  }

  Assignment
  Result() const
  {
    Assignment result;
    result.choice.assign(m_Problem.candidates.size(), -1);
    result.cost = std::accumulate(m_Problem.columnAlone.begin(), m_Problem.columnAlone.end(), 0.0);
    for (std::size_t column = 0; column < m_RowOfColumn.size(); ++column)
    {
      const int row = m_RowOfColumn[column];
      if (row >= 0)
      {
        result.choice[row] = m_ChoiceOfColumn[column];
        result.cost += this->CostOf(row, m_ChoiceOfColumn[column]);
      }
    }
    return result;
  }

private:
  int
  ColumnOf(int row, int choice) const
  {
    return choice < 0 ? m_Columns + row : m_Problem.candidates[row][choice].column;
  }

  /** Change in the cost relative to an unassigned column. */
  double
  CostOf(int row, int choice) const
  {
    if (choice < 0)
    {
      return m_Problem.rowAlone[row];
    }
    const AssignmentProblem::Candidate & candidate = m_Problem.candidates[row][choice];
    return candidate.cost - m_Problem.columnAlone[candidate.column];
  }

  double
  LeastReducedCost(int row) const
  {
    double least = unreached;
    for (int choice = -1; choice < static_cast<int>(m_Problem.candidates[row].size()); ++choice)
    {
      least = std::min(least, this->CostOf(row, choice) - m_ColumnPotential[this->ColumnOf(row, choice)]);
    }
    return least;
  }

  void
  Relax(int row, double distance)
  {
    for (int choice = -1; choice < static_cast<int>(m_Problem.candidates[row].size()); ++choice)
    {
      const int    column = this->ColumnOf(row, choice);
      const double sum = distance + this->CostOf(row, choice) - m_RowPotential[row] - m_ColumnPotential[column];
      if (!m_IsDone[column] && sum < m_Distance[column])
      {
        m_Distance[column] = sum;
        m_From[column] = row;
        m_Through[column] = choice;
        m_Queue.push({ sum, column });
      }
    }
  }

  void
  UpdatePotentials(int row, double length)
  {
    m_RowPotential[row] += length;
    for (std::size_t column = 0; column < m_IsDone.size(); ++column)
    {
      if (m_IsDone[column])
      {
        const double gain = length - m_Distance[column];
        m_ColumnPotential[column] -= gain;
        if (m_RowOfColumn[column] >= 0)
        {
          m_RowPotential[m_RowOfColumn[column]] += gain;
        }
      }
    }
  }

  /** Augments the assignment along the path that ends at this column. */
  void
  Flip(int column)
  {
    while (column >= 0)
    {
      const int row = m_From[column];
      int       previous = -1;
      for (int choice = -1; choice < static_cast<int>(m_Problem.candidates[row].size()); ++choice)
      {
        const int other = this->ColumnOf(row, choice);
        previous = other != column && m_RowOfColumn[other] == row ? other : previous;
      }
      m_RowOfColumn[column] = row;
      m_ChoiceOfColumn[column] = m_Through[column];
      if (previous >= 0)
      {
        m_RowOfColumn[previous] = -1; // assigned in the next step of the path
      }
      column = previous;
    }
  }

  const AssignmentProblem &                                                                        m_Problem;
  int                                                                                              m_Columns;
  std::vector<int>                                                                                 m_RowOfColumn;
  std::vector<int>                                                                                 m_ChoiceOfColumn;
  std::vector<double>                                                                              m_RowPotential;
  std::vector<double>                                                                              m_ColumnPotential;
  std::vector<double>                                                                              m_Distance;
  std::vector<int>                                                                                 m_From;
  std::vector<int>                                                                                 m_Through;
  std::vector<char>                                                                                m_IsDone;
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> m_Queue;
};
} // namespace

Assignment
SolveAssignment(const AssignmentProblem & problem)
{
  AugmentingPaths paths(problem);
  for (std::size_t row = 0; row < problem.candidates.size(); ++row)
  {
    paths.Augment(static_cast<int>(row));
  }
  return paths.Result();
}
} // namespace shapeton
