#include "shapetonDualDecomposition.h"

#include <limits>

namespace shapeton
{
namespace
{
class DualAscent
{
public:
  DualAscent(const AssignmentProblem & problem, const std::vector<PairTerm> & pairs)
    : m_Problem(problem), m_Modified(problem), m_Pairs(pairs)
  {
    for (const PairTerm & pair : pairs)
    {
      m_First.emplace_back(Eigen::VectorXd::Zero(pair.cost.rows()));
      m_Second.emplace_back(Eigen::VectorXd::Zero(pair.cost.cols()));
    }
    m_Best.bound = -std::numeric_limits<double>::infinity();
    m_Best.assignment.cost = std::numeric_limits<double>::infinity();
  }

  PairedAssignment
  Run(int iterations)
  {
    constexpr double closed = 1e-9; // gap of the costs, for rounding
    for (int t = 0; t < iterations && m_Best.assignment.cost - m_Best.bound > closed; ++t)
    {
      const double firstStep = 1.5; // cost; chosen
      const double halfLife = 25.0; // iterations until the step is halved; chosen
      this->Iterate(0.5 * firstStep / (1.0 + t / halfLife));
      m_Best.iterations = t + 1;
    }
    return m_Best;
  }

private:
  int
  LabelOf(const std::vector<int> & choice, int row) const
  {
    return choice[row] < 0 ? static_cast<int>(m_Problem.candidates[row].size()) : choice[row];
  }

  /** Adds a value to the cost of a label in the assignment subproblem. */
  void
  AddToLabel(AssignmentProblem & problem, int row, int label, double value) const
  {
    const bool isAlone = label == static_cast<int>(problem.candidates[row].size());
    (isAlone ? problem.rowAlone[row] : problem.candidates[row][label].cost) += value;
  }

  void
  Iterate(double step)
  {
    m_Modified = m_Problem;
    AssignmentProblem votes = m_Problem; // rounding dominated by the pair subproblems
    for (std::size_t p = 0; p < m_Pairs.size(); ++p)
    {
      for (int label = 0; label < m_First[p].size(); ++label)
      {
        this->AddToLabel(m_Modified, m_Pairs[p].first, label, -m_First[p][label]);
      }
      for (int label = 0; label < m_Second[p].size(); ++label)
      {
        this->AddToLabel(m_Modified, m_Pairs[p].second, label, -m_Second[p][label]);
      }
    }
    const Assignment whole = SolveAssignment(m_Modified);
    double           dual = whole.cost;
    for (std::size_t p = 0; p < m_Pairs.size(); ++p)
    {
      Eigen::Index          a = 0, b = 0;
      const Eigen::MatrixXd cost = (m_Pairs[p].cost.colwise() + m_First[p]).rowwise() + m_Second[p].transpose();
      dual += cost.minCoeff(&a, &b);
      this->AddToLabel(votes, m_Pairs[p].first, static_cast<int>(a), -1.0);
      this->AddToLabel(votes, m_Pairs[p].second, static_cast<int>(b), -1.0);
      m_First[p][a] += step;
      m_First[p][this->LabelOf(whole.choice, m_Pairs[p].first)] -= step;
      m_Second[p][b] += step;
      m_Second[p][this->LabelOf(whole.choice, m_Pairs[p].second)] -= step;
    }
    m_Best.bound = std::max(m_Best.bound, dual);
    this->Consider(whole.choice);
    this->Consider(SolveAssignment(votes).choice);
  }

  void
  Consider(const std::vector<int> & choice)
  {
    double cost = 0.0;
    for (const double alone : m_Problem.columnAlone)
    {
      cost += alone;
    }
    for (std::size_t row = 0; row < choice.size(); ++row)
    {
      const bool isAlone = choice[row] < 0;
      cost += isAlone ? m_Problem.rowAlone[row]
                      : m_Problem.candidates[row][choice[row]].cost -
                          m_Problem.columnAlone[m_Problem.candidates[row][choice[row]].column];
    }
    for (const PairTerm & pair : m_Pairs)
    {
      cost += pair.cost(this->LabelOf(choice, pair.first), this->LabelOf(choice, pair.second));
    }
    if (cost < m_Best.assignment.cost)
    {
      m_Best.assignment = { choice, cost };
    }
  }

  const AssignmentProblem &     m_Problem;
  AssignmentProblem             m_Modified;
  const std::vector<PairTerm> & m_Pairs;
  std::vector<Eigen::VectorXd>  m_First; ///< multipliers
  std::vector<Eigen::VectorXd>  m_Second;
  PairedAssignment              m_Best;
};
} // namespace

PairedAssignment
SolvePairedAssignment(const AssignmentProblem & problem, const std::vector<PairTerm> & pairs, int iterations)
{
  return DualAscent(problem, pairs).Run(iterations);
}
} // namespace shapeton
