#include "shapetonCurvatureNewton.h"

#include "shapetonExceptions.h"
#include "shapetonNumberText.h"
#include "shapetonSparseCholesky.h"

#include <algorithm>
#include <memory>
#include <numeric>

namespace shapeton
{
namespace
{
constexpr int mostSteps = 200;   // 5 to 40 are usual
constexpr int mostHalvings = 40; // of a step; chosen, 2^-40 of it has no effect
/** Largest change of u in one step, that is, of the logarithm of a length. Longer steps occur only far from the region
 * where the quadratic model holds, and they cause many flips. From 2 to 10 the number of steps hardly changes. */
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

  /** Two unknowns of an edge, the smaller one first; -1 if one is fixed. */
  std::array<int, 2>
  UnknownsOf(int edge) const
  {
    const IntrinsicTriangulation & triangulation = m_Metric.Triangulation();
    const int                      side = triangulation.SideOf(edge);
    const int                      a = m_Place[m_Unknowns.ofVertices[triangulation.Origin(side)]];
    const int                      b = m_Place[m_Unknowns.ofVertices[triangulation.End(side)]];
    return { std::min(a, b), std::max(a, b) };
  }

  /** For each edge between two different unknowns, the larger unknown and the edge number, in buckets by the smaller
   * unknown; also resets the kinds of all edges. */
  std::vector<std::array<int, 2>>
  EdgesByFirstUnknown(std::vector<int> & begin)
  {
    const int edges = m_Metric.Triangulation().NumberOfEdges();
    m_PairOfEdge.assign(edges, { Kind::Fixed, -1 });
    std::vector<std::array<int, 2>> unknowns(edges);
    for (int e = 0; e < edges; ++e)
    {
      const auto [a, b] = unknowns[e] = this->UnknownsOf(e);
      if (a != -1 && a == b)
      {
        m_PairOfEdge[e] = { Kind::Loop, a };
      }
      else if (a != -1)
      {
        ++begin[a + 1];
      }
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<int>                next = begin;
    std::vector<std::array<int, 2>> buckets(begin.back());
    for (int e = 0; e < edges; ++e)
    {
      if (const auto [a, b] = unknowns[e]; a != -1 && a != b)
      {
        buckets[next[a]++] = { b, e };
      }
    }
    return buckets;
  }

  /** Symbolic factorization of the current triangulation. */
  void
  Analyze()
  {
    if (m_Factor && m_Changes == m_Metric.Changes())
    {
      return;
    }
    m_Changes = m_Metric.Changes();
    std::vector<std::array<int, 2>> pairs;
    std::vector<int>                begin(m_Free + 1, 0);
    auto                            buckets = this->EdgesByFirstUnknown(begin);
    for (int first = 0; first < m_Free; ++first)
    {
      std::sort(buckets.begin() + begin[first], buckets.begin() + begin[first + 1]);
      for (int i = begin[first]; i < begin[first + 1]; ++i)
      {
        const auto [second, edge] = buckets[i];
        if (i == begin[first] || buckets[i - 1][0] != second)
        {
          pairs.push_back({ first, second });
        }
        m_PairOfEdge[edge] = { Kind::Pair, static_cast<int>(pairs.size()) - 1 };
      }
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
                  const RicciTolerance &  tolerance,
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
  for (solution.residual = first; solution.residual > tolerance.goal; ++solution.steps)
  {
    progress(1.0 - std::log(solution.residual / tolerance.goal) / std::log(std::max(first / tolerance.goal, 2.0)));
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
    if (!isBetter && solution.residual <= tolerance.accepted)
    {
      newton.Set(solution.u);
      return solution;
    }
    if (!isBetter)
    {
      throw InputError("the Ricci flow stops at a curvature error of " + NumberText(solution.residual) + " after " +
                       std::to_string(solution.steps) + " steps");
    }
    const double before = solution.residual;
    solution.residual = LargestOf(gradient);
    if (before <= tolerance.accepted && solution.residual > 0.5 * before)
    {
      break; // rounding errors
    }
  }
  return solution;
}
} // namespace shapeton
