#include "shapetonQuasiConformalMap.h"

#include "shapetonSparseCholesky.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shapeton
{
namespace
{
using Coefficients = BeltramiEquations::Coefficients;

double
ValueOf(const MapCondition & condition, const Eigen::VectorXd & coordinate)
{
  double value = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    value += condition.share[k] * coordinate[condition.node[k]];
  }
  return value;
}

double
GreatestMiss(const std::vector<MapCondition> & conditions, const Eigen::VectorXd & coordinate)
{
  double greatest = 0.0;
  for (const MapCondition & condition : conditions)
  {
    greatest = std::max(greatest, std::abs(ValueOf(condition, coordinate) - condition.value));
  }
  return greatest;
}

/** Adds weight * share * share^T for each constraint. The nodes of a constraint are the corners of one triangle, so the
 * sparsity pattern is unchanged. */
void
AddConditions(const std::vector<MapCondition> & conditions, double weight, Eigen::SparseMatrix<double> & matrix)
{
  for (const MapCondition & condition : conditions)
  {
    for (int a = 0; a < 3; ++a)
    {
      for (int b = 0; b < 3; ++b)
      {
        matrix.coeffRef(condition.node[a], condition.node[b]) += weight * condition.share[a] * condition.share[b];
      }
    }
  }
}

/** Reuses the symbolic factorization, which is independent of coefficients and constraints. */
class ConditionedSolver
{
public:
  explicit ConditionedSolver(const BeltramiEquations & equations)
    : m_Equations(equations)
    , m_Solver(SymbolicFactorization(equations.SystemOf(Coefficients(equations.Triangles())).stiffness,
                                     EliminationOrder::NestedDissection))
  {}

  CylinderValues
  Solve(const Coefficients & mu, const MapConditions & conditions)
  {
    const BeltramiEquations::System system = m_Equations.SystemOf(mu);
    return { this->Coordinate(system.stiffness, Eigen::VectorXd::Zero(m_Equations.Nodes()), conditions.along),
             this->Coordinate(system.stiffness, system.turn, conditions.around) };
  }

private:
  /** Minimizes the energy under constraints by the method of multipliers. Each iteration reduces the violation by a
   * factor equal to the ratio of constraint weight to stiffness, so few iterations are required. */
  Eigen::VectorXd
  Coordinate(Eigen::SparseMatrix<double>       stiffness,
             const Eigen::VectorXd &           right,
             const std::vector<MapCondition> & conditions)
  {
    constexpr double weight = 1e4; // relative to the stiffness, see above; chosen
    constexpr double exact = 1e-9; // mm
    constexpr int    rounds = 20;  // chosen: bounds the time
    if (conditions.empty())
    {
      throw std::invalid_argument("a map needs at least one condition for each coordinate");
    }
    AddConditions(conditions, weight, stiffness);
    if (!m_Solver.Factorize(stiffness))
    {
      throw std::runtime_error("the linear system of a quasi-conformal map is singular");
    }
    std::vector<double> pull(conditions.size());
    std::transform(conditions.begin(), conditions.end(), pull.begin(), [](const MapCondition & condition) {
      return weight * condition.value;
    });
    Eigen::VectorXd coordinate;
    for (int round = 0; round < rounds; ++round)
    {
      coordinate = right;
      for (std::size_t i = 0; i < conditions.size(); ++i)
      {
        for (int k = 0; k < 3; ++k)
        {
          coordinate[conditions[i].node[k]] += pull[i] * conditions[i].share[k];
        }
      }
      m_Solver.SolveInPlace(coordinate);
      for (std::size_t i = 0; i < conditions.size(); ++i)
      {
        pull[i] += weight * (conditions[i].value - ValueOf(conditions[i], coordinate));
      }
      if (GreatestMiss(conditions, coordinate) < exact)
      {
        break;
      }
    }
    return coordinate;
  }

  const BeltramiEquations & m_Equations;
  SparseCholesky            m_Solver;
};

/** Solves (mass + length^2 stiffness) nu = mass mu at the nodes. Right triangles do not have negative weights, so the
 * maximum principle holds. */
class CoefficientSmoother
{
public:
  CoefficientSmoother(const BeltramiEquations & equations, double length)
    : m_Equations(equations), m_Mass(Eigen::VectorXd::Zero(equations.Nodes())), m_Solver(this->Factorized(length))
  {}

  Coefficients
  operator()(const Coefficients & mu) const
  {
    Eigen::MatrixX2d ofNodes = Eigen::MatrixX2d::Zero(m_Equations.Nodes(), 2);
    for (int t = 0; t < m_Equations.Triangles(); ++t)
    {
      for (const int node : m_Equations.TriangleOf(t).node)
      {
        ofNodes.row(node) += m_Equations.AreaOf(t) / 3.0 * Eigen::RowVector2d(mu[t].real(), mu[t].imag());
      }
    }
    m_Solver.SolveInPlace(ofNodes);
    Coefficients smooth(mu.size());
    for (int t = 0; t < m_Equations.Triangles(); ++t)
    {
      for (const int node : m_Equations.TriangleOf(t).node)
      {
        smooth[t] += std::complex<double>(ofNodes(node, 0), ofNodes(node, 1)) / 3.0;
      }
    }
    return smooth;
  }

private:
  SparseCholesky
  Factorized(double length)
  {
    for (int t = 0; t < m_Equations.Triangles(); ++t)
    {
      for (const int node : m_Equations.TriangleOf(t).node)
      {
        m_Mass[node] += m_Equations.AreaOf(t) / 3.0;
      }
    }
    Eigen::SparseMatrix<double> matrix =
      length * length * m_Equations.SystemOf(Coefficients(m_Equations.Triangles())).stiffness;
    matrix.diagonal() += m_Mass;
    SparseCholesky solver(SymbolicFactorization(matrix, EliminationOrder::MinimumDegree));
    if (!solver.Factorize(matrix))
    {
      throw std::runtime_error("the linear system that smooths Beltrami coefficients is singular");
    }
    return solver;
  }

  const BeltramiEquations & m_Equations;
  Eigen::VectorXd           m_Mass;
  SparseCholesky            m_Solver;
};

Coefficients
Cut(Coefficients mu, double greatest)
{
  for (std::complex<double> & value : mu)
  {
    value *= std::min(1.0, greatest / std::max(std::abs(value), greatest));
  }
  return mu;
}

double
GreatestDifference(const Coefficients & a, const Coefficients & b)
{
  double greatest = 0.0;
  for (std::size_t t = 0; t < a.size(); ++t)
  {
    greatest = std::max(greatest, std::abs(a[t] - b[t]));
  }
  return greatest;
}
double
GreatestCoefficient(const Coefficients & mu)
{
  return GreatestDifference(mu, Coefficients(mu.size()));
}

/** Iterates until constraints that depend on the map are satisfied. */
void
SettleConditions(ConditionedSolver &                                              solver,
                 const Coefficients &                                             mu,
                 const std::function<MapConditions(const CylinderValues & map)> & conditionsOf,
                 QuasiConformalMap &                                              map,
                 const Progress &                                                 progress)
{
  constexpr int    rounds = 8;   // chosen: bounds the time
  constexpr double exact = 1e-6; // mm
  MapConditions    conditions = conditionsOf(map.values);
  for (int round = 0; round < rounds; ++round)
  {
    map.values = solver.Solve(mu, conditions);
    ++map.solves;
    progress((round + 1.0) / rounds);
    conditions = conditionsOf(map.values);
    map.greatestMiss =
      std::max(GreatestMiss(conditions.along, map.values.along), GreatestMiss(conditions.around, map.values.around));
    if (map.greatestMiss < exact)
    {
      break;
    }
  }
}
} // namespace

CylinderValues
SolveBeltrami(const BeltramiEquations & equations, const Coefficients & mu, const MapConditions & conditions)
{
  return ConditionedSolver(equations).Solve(mu, conditions);
}

QuasiConformalMap
FindQuasiConformalMap(const BeltramiEquations &                                        equations,
                      CylinderValues                                                   start,
                      const std::function<MapConditions(const CylinderValues & map)> & conditionsOf,
                      const QuasiConformalOptions &                                    options)
{
  ConditionedSolver         solver(equations);
  const CoefficientSmoother smooth(equations, options.smoothing);
  QuasiConformalMap         map;
  map.values = std::move(start);
  Coefficients mu(equations.Triangles());
  for (int round = 0; round < options.iterations; ++round)
  {
    map.values = solver.Solve(mu, conditionsOf(map.values));
    ++map.solves;
    options.progress(0.8 * (round + 1.0) / options.iterations);
    const Coefficients next = smooth(Cut(equations.CoefficientsOf(map.values, map.flips), options.greatest));
    const double       change = GreatestDifference(next, mu);
    if (change <= options.tolerance)
    {
      break;
    }
    mu = next;
  }
  SettleConditions(solver, mu, conditionsOf, map, options.progress.Part("", 0.8, 1.0));
  map.greatest = GreatestCoefficient(equations.CoefficientsOf(map.values, map.flips));
  return map;
}
} // namespace shapeton
