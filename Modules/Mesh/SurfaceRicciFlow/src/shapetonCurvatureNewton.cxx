#include "shapetonCurvatureNewton.h"

#include "shapetonExceptions.h"
#include "shapetonNumberText.h"
#include "shapetonSparseCholesky.h"

#include <algorithm>
#include <memory>

namespace shapeton
{
namespace
{
constexpr int mostSteps = 200; // 5 to 40 are usual
constexpr int mostHalvings = 40;
/** Largest change of u in one step, that is, of the logarithm of a length. Longer steps start far from the region where
 * the quadratic model holds, and cause many flips. From 2 to 10 the number of steps hardly changes. */
constexpr double longestStep = 5.0;

class Newton
{
public:
  Newton(ConformalMetric & metric, const RicciUnknowns & unknowns) : m_Metric(metric), m_Unknowns(unknowns)
  {
    for (Eigen::Index i = 0; i < unknowns.angles.size(); ++i)
    {
      m_Place.push_back(unknowns.isFixed[i] || i == unknowns.gauge ? -1 : m_Free++);
    }
  }

  bool
  Set(const Eigen::VectorXd & u)
  {
    Eigen::VectorXd ofVertices(m_Unknowns.ofVertices.size());
    for (Eigen::Index v = 0; v < ofVertices.size(); ++v)
    {
      ofVertices[v] = u[m_Unknowns.ofVertices[v]];
    }
    return m_Metric.SetFactors(ofVertices);
  }

  /** Curvature minus target, 0 at fixed unknowns. */
  Eigen::VectorXd
  Gradient() const
  {
    const Eigen::VectorXd sums = m_Metric.AngleSums();
    Eigen::VectorXd       gradient = m_Unknowns.angles;
    for (Eigen::Index v = 0; v < sums.size(); ++v)
    {
      gradient[m_Unknowns.ofVertices[v]] -= sums[v] / m_Unknowns.copies;
    }
    for (Eigen::Index i = 0; i < gradient.size(); ++i)
    {
      gradient[i] = m_Unknowns.isFixed[i] ? 0.0 : gradient[i];
    }
    return gradient;
  }

  Eigen::VectorXd
  Step(const Eigen::VectorXd & gradient)
  {
    this->Analyze();
    const CurvatureDerivatives derivatives = m_Metric.Derivatives();
    Eigen::VectorXd            diagonal = Eigen::VectorXd::Zero(m_Free);
    Eigen::VectorXd            offDiagonal = Eigen::VectorXd::Zero(m_Symbolic->NumberOfEdges());
    for (std::size_t v = 0; v < m_Unknowns.ofVertices.size(); ++v)
    {
      if (const int place = m_Place[m_Unknowns.ofVertices[v]]; place != -1)
      {
        diagonal[place] += derivatives.diagonal[static_cast<Eigen::Index>(v)] / m_Unknowns.copies;
      }
    }
    for (std::size_t e = 0; e < m_PairOfEdge.size(); ++e)
    {
      const double value = derivatives.ofEdges[static_cast<Eigen::Index>(e)] / m_Unknowns.copies;
      const auto [kind, place] = m_PairOfEdge[e];
      if (kind == Kind::Loop)
      {
        diagonal[place] += 2.0 * value;
      }
      else if (kind == Kind::Pair)
      {
        offDiagonal[place] += value;
      }
    }
    if (!m_Factor->Factorize(diagonal, offDiagonal))
    {
      throw InputError("the Ricci flow fails: the Hessian of its energy is not positive definite");
    }
    Eigen::MatrixXd step(m_Free, 1);
    for (std::size_t i = 0; i < m_Place.size(); ++i)
    {
      if (m_Place[i] != -1)
      {
        step(m_Place[i], 0) = -gradient[static_cast<Eigen::Index>(i)];
      }
    }
    m_Factor->SolveInPlace(step);
    Eigen::VectorXd result = Eigen::VectorXd::Zero(gradient.size());
    for (std::size_t i = 0; i < m_Place.size(); ++i)
    {
      result[static_cast<Eigen::Index>(i)] = m_Place[i] == -1 ? 0.0 : step(m_Place[i], 0);
    }
    return result;
  }

private:
  enum class Kind
  {
    Fixed,
    Loop, ///< both ends have the same unknown
    Pair
  };

  /** Symbolic factorization of the current triangulation. */
  void
  Analyze()
  {
    if (m_Factor && m_Changes == m_Metric.Changes())
    {
      return;
    }
    m_Changes = m_Metric.Changes();
    const IntrinsicTriangulation &  triangulation = m_Metric.Triangulation();
    std::vector<std::array<int, 3>> sorted; // two places and the edge
    m_PairOfEdge.assign(triangulation.NumberOfEdges(), { Kind::Fixed, -1 });
    for (int e = 0; e < triangulation.NumberOfEdges(); ++e)
    {
      const int side = triangulation.SideOf(e);
      const int a = m_Place[m_Unknowns.ofVertices[triangulation.Origin(side)]];
      const int b = m_Place[m_Unknowns.ofVertices[triangulation.End(side)]];
      if (a != -1 && a == b)
      {
        m_PairOfEdge[e] = { Kind::Loop, a };
      }
      else if (a != -1 && b != -1)
      {
        sorted.push_back({ std::min(a, b), std::max(a, b), e });
      }
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::array<int, 2>> pairs;
    for (const auto & [a, b, edge] : sorted)
    {
      if (pairs.empty() || pairs.back() != std::array<int, 2>{ a, b })
      {
        pairs.push_back({ a, b });
      }
      m_PairOfEdge[edge] = { Kind::Pair, static_cast<int>(pairs.size()) - 1 };
    }
    if (pairs != m_Pairs || !m_Factor)
    {
      m_Symbolic = std::make_unique<SymbolicFactorization>(m_Free, pairs, EliminationOrder::MinimumDegree);
      m_Factor = std::make_unique<SparseCholesky>(*m_Symbolic);
      m_Pairs = std::move(pairs);
    }
  }

  ConformalMetric &                      m_Metric;
  const RicciUnknowns &                  m_Unknowns;
  std::vector<int>                       m_Place; ///< among the free unknowns, or -1
  int                                    m_Free{ 0 };
  int                                    m_Changes{ -1 };
  std::vector<std::array<int, 2>>        m_Pairs;
  std::vector<std::pair<Kind, int>>      m_PairOfEdge;
  std::unique_ptr<SymbolicFactorization> m_Symbolic;
  std::unique_ptr<SparseCholesky>        m_Factor;
};

double
LargestOf(const Eigen::VectorXd & values)
{
  return values.size() == 0 ? 0.0 : values.cwiseAbs().maxCoeff();
}
} // namespace

RicciSolution
SolveForCurvature(ConformalMetric &       metric,
                  const RicciUnknowns &   unknowns,
                  const Eigen::VectorXd & start,
                  double                  tolerance,
                  const Progress &        progress)
{
  Newton        newton(metric, unknowns);
  RicciSolution solution{ start };
  if (!newton.Set(start))
  {
    throw InputError("the Ricci flow cannot start: a face violates the triangle inequality");
  }
  Eigen::VectorXd gradient = newton.Gradient();
  const double    first = LargestOf(gradient);
  for (solution.residual = first; solution.residual > tolerance; ++solution.steps)
  {
    progress(1.0 - std::log(solution.residual / tolerance) / std::log(std::max(first / tolerance, 2.0)));
    const Eigen::VectorXd step = newton.Step(gradient);
    const double          descent = -gradient.dot(step);
    double                part = std::min(1.0, longestStep / std::max(LargestOf(step), 1e-300));
    bool                  isBetter = false;
    for (int i = 0; i < mostHalvings && !isBetter && solution.steps < mostSteps; ++i, part *= 0.5)
    {
      if (!newton.Set(solution.u + part * step))
      {
        continue;
      }
      const Eigen::VectorXd next = newton.Gradient();
      const double          slope = next.dot(step);
      isBetter = slope <= 0.0 || (slope <= 0.5 * descent && next.squaredNorm() < gradient.squaredNorm());
      if (isBetter)
      {
        solution.u += part * step;
        gradient = next;
      }
    }
    if (!isBetter)
    {
      throw InputError("the Ricci flow stops at a curvature error of " + NumberText(solution.residual) + " after " +
                       std::to_string(solution.steps) + " steps");
    }
    solution.residual = LargestOf(gradient);
  }
  return solution;
}
} // namespace shapeton
