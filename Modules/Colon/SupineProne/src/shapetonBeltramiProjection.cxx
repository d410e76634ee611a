#include "shapetonBeltramiProjection.h"

#include "shapetonSparseCholesky.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>

namespace shapeton
{
namespace
{
using Complex = std::complex<double>;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Gradients = Eigen::Matrix<double, 2, 3>;

/** Triangles of the nodes, in the plane (mm along, mm around); both kinds have one form each. */
class BeltramiSolver
{
public:
  BeltramiSolver(const CylinderNodes & nodes, double sourceAround, double targetAround)
    : m_Rows(nodes.Rows()), m_Angles(nodes.Angles()), m_TargetAround(targetAround)
  {
    const double h = nodes.step;
    const double w = sourceAround / m_Angles;
    m_Area = 0.5 * h * w;
    m_Gradients[0] << -1 / h, 1 / h, 0.0, 0.0, -1 / w, 1 / w;
    m_Gradients[1] << 0.0, 1 / h, -1 / h, -1 / w, 0.0, 1 / w;
    m_S = Eigen::Map<const Eigen::VectorXd>(Eigen::MatrixXd(nodes.s.transpose()).data(), nodes.s.size());
    m_X = Eigen::Map<const Eigen::VectorXd>(Eigen::MatrixXd(nodes.turn.transpose()).data(), nodes.s.size());
    m_X *= targetAround;
    m_S.head(m_Angles).setConstant(m_S.head(m_Angles).mean());
    m_S.tail(m_Angles).setConstant(m_S.tail(m_Angles).mean());
  }

  int
  Triangles() const
  {
    return 2 * (m_Rows - 1) * m_Angles;
  }

  /** Of each triangle; infinite where the map has no derivative that turns the right way. `flips` counts those turned
   * over. */
  std::vector<Complex>
  Coefficients(int & flips) const
  {
    std::vector<Complex> mu(this->Triangles());
    flips = 0;
    for (int t = 0; t < this->Triangles(); ++t)
    {
      Eigen::Vector3d s, x;
      this->ValuesOf(t, s, x);
      const Gradients &     gradients = m_Gradients[t % 2];
      const Eigen::Vector2d ds = gradients * s;
      const Eigen::Vector2d dx = gradients * x;
      const Complex         alongS(ds[0], dx[0]);
      const Complex         alongX(ds[1], dx[1]);
      const Complex         i(0.0, 1.0);
      const Complex         conformal = alongS - i * alongX;
      mu[t] = (alongS + i * alongX) / (std::abs(conformal) > 1e-12 ? conformal : Complex(1e-12, 0.0));
      flips += !(ds[0] * dx[1] - ds[1] * dx[0] > 0.0);
    }
    return mu;
  }

  /** Cuts coefficients to `greatest`, and takes the mean of the neighbourhood where that was needed; false where none
   * was too large. */
  bool
  Bound(std::vector<Complex> & mu, double greatest) const
  {
    std::vector<char> isCut(mu.size(), 0);
    bool              isAny = false;
    for (std::size_t t = 0; t < mu.size(); ++t)
    {
      if (!(std::abs(mu[t]) <= greatest))
      {
        mu[t] *= greatest / std::abs(mu[t]);
        isCut[t] = 1;
        isAny = true;
      }
    }
    constexpr int passes = 2;
    for (int pass = 0; pass < passes && isAny; ++pass)
    {
      this->Smooth(mu, isCut);
    }
    return isAny;
  }

  /** The map with these coefficients. */
  void
  Solve(const std::vector<Complex> & mu)
  {
    const int                           nodes = m_Rows * m_Angles;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd                     jump = Eigen::VectorXd::Zero(nodes); // what the turn adds to the equations of x
    for (int t = 0; t < this->Triangles(); ++t)
    {
      const Eigen::Matrix3d local =
        m_Area * m_Gradients[t % 2].transpose() * this->Conductivity(mu[t]) * m_Gradients[t % 2];
      int node[3], around[3];
      this->CornersOf(t, node, around);
      for (int a = 0; a < 3; ++a)
      {
        for (int b = 0; b < 3; ++b)
        {
          entries.emplace_back(node[a], node[b], local(a, b));
          jump[node[a]] -= local(a, b) * around[b] * m_TargetAround;
        }
      }
    }
    SparseMatrix stiffness(nodes, nodes);
    stiffness.setFromTriplets(entries.begin(), entries.end());
    const double meanBefore = m_X.mean();
    this->SolveWithFixed(stiffness, Eigen::VectorXd::Zero(nodes), m_Angles, m_S);
    this->SolveWithFixed(stiffness, jump, 0, m_X);
    m_X.array() += meanBefore - m_X.mean();
  }

  CylinderNodes
  Nodes(CylinderNodes like) const
  {
    for (int i = 0; i < m_Rows; ++i)
    {
      like.s.row(i) = m_S.segment(i * m_Angles, m_Angles).transpose();
      like.turn.row(i) = m_X.segment(i * m_Angles, m_Angles).transpose() / m_TargetAround;
    }
    return like;
  }

private:
  void
  CornersOf(int t, int (&node)[3], int (&around)[3]) const
  {
    const int  row = t / 2 / m_Angles;
    const int  j = t / 2 % m_Angles;
    const int  next = (j + 1) % m_Angles;
    const int  turned = next == 0;
    const bool isSecond = t % 2 != 0;
    node[0] = row * m_Angles + j;
    node[1] = (row + 1) * m_Angles + (isSecond ? next : j);
    node[2] = (row + (isSecond ? 0 : 1)) * m_Angles + next;
    around[0] = 0;
    around[1] = isSecond ? turned : 0;
    around[2] = turned;
  }

  void
  ValuesOf(int t, Eigen::Vector3d & s, Eigen::Vector3d & x) const
  {
    int node[3], around[3];
    this->CornersOf(t, node, around);
    for (int k = 0; k < 3; ++k)
    {
      s[k] = m_S[node[k]];
      x[k] = m_X[node[k]] + around[k] * m_TargetAround;
    }
  }

  /** Both components of a map with the coefficient mu are harmonic with this conductivity. */
  static Eigen::Matrix2d
  Conductivity(Complex mu)
  {
    const double    r = mu.real();
    const double    t = mu.imag();
    Eigen::Matrix2d conductivity;
    conductivity << (r - 1) * (r - 1) + t * t, -2 * t, -2 * t, (1 + r) * (1 + r) + t * t;
    return conductivity / (1.0 - r * r - t * t);
  }

  /** What was cut takes the mean of the triangles at its corners. */
  void
  Smooth(std::vector<Complex> & mu, const std::vector<char> & isCut) const
  {
    std::vector<Complex> sum(m_Rows * m_Angles);
    std::vector<int>     number(m_Rows * m_Angles, 0);
    int                  node[3], around[3];
    for (std::size_t t = 0; t < mu.size(); ++t)
    {
      this->CornersOf(static_cast<int>(t), node, around);
      for (const int corner : node)
      {
        sum[corner] += mu[t];
        ++number[corner];
      }
    }
    for (std::size_t t = 0; t < mu.size(); ++t)
    {
      if (isCut[t])
      {
        this->CornersOf(static_cast<int>(t), node, around);
        mu[t] = 0.0;
        for (const int corner : node)
        {
          mu[t] += sum[corner] / (3.0 * number[corner]);
        }
      }
    }
  }

  /** Solves stiffness * values = right with the first and last `ends` nodes as they are (the first one alone for 0). */
  void
  SolveWithFixed(const SparseMatrix & stiffness, Eigen::VectorXd right, int ends, Eigen::VectorXd & values) const
  {
    const int       nodes = static_cast<int>(values.size());
    const int       first = std::max(1, ends);
    const int       inner = nodes - first - ends;
    Eigen::VectorXd fixed = values;
    fixed.segment(first, inner).setZero();
    right -= stiffness * fixed;
    if (!SolvePositiveDefinite(stiffness.block(first, first, inner, inner), right.segment(first, inner)))
    {
      throw std::runtime_error("the equations of the Beltrami solver cannot be solved");
    }
    values.segment(first, inner) = right.segment(first, inner);
  }

  int             m_Rows;
  int             m_Angles;
  double          m_TargetAround;
  double          m_Area;
  Gradients       m_Gradients[2];
  Eigen::VectorXd m_S; ///< mm, row by row
  Eigen::VectorXd m_X; ///< mm around
};

double
GreatestOf(const std::vector<Complex> & mu)
{
  double greatest = 0.0;
  for (const Complex & value : mu)
  {
    greatest = std::max(greatest, std::abs(value));
  }
  return greatest;
}
} // namespace

BeltramiProjection
ProjectToBijection(const CylinderNodes &             nodes,
                   double                            sourceAround,
                   double                            targetAround,
                   const BeltramiProjectionOptions & options)
{
  BeltramiSolver       solver(nodes, sourceAround, targetAround);
  BeltramiProjection   projection;
  std::vector<Complex> mu = solver.Coefficients(projection.flipsBefore);
  projection.greatestBefore = GreatestOf(mu);
  projection.flips = projection.flipsBefore;
  double bound = options.greatest;
  while (projection.iterations < options.iterations && solver.Bound(mu, bound))
  {
    solver.Solve(mu);
    mu = solver.Coefficients(projection.flips);
    ++projection.iterations;
    bound *= projection.flips > 0 ? 0.9 : 1.0;
    if (projection.flips == 0 && GreatestOf(mu) < 0.5 * (1.0 + options.greatest))
    {
      break; // coefficients a little above the bound are no fault of a bijection
    }
  }
  projection.greatest = GreatestOf(mu);
  projection.nodes = solver.Nodes(nodes);
  return projection;
}
} // namespace shapeton
