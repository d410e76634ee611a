#include "shapetonSpectralMeasure.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Sufficient for converged curves: the error of exp(-t A) decreases like exp(-steps^2 / (t |A|)). */
constexpr int Steps = 240;

/** Tridiagonal matrix of the Lanczos process from b. Without reorthogonalization, eigenvalues are repeated and share
 * their weight. */
struct Tridiagonal
{
  std::vector<double> diagonal;
  std::vector<double> below;
};

Tridiagonal
Lanczos(const SymmetricMatrix & A, const Eigen::VectorXd & b)
{
  Tridiagonal     matrix;
  Eigen::VectorXd previous = Eigen::VectorXd::Zero(b.size());
  Eigen::VectorXd vector = b / b.norm();
  double          beta = 0.0;
  const auto      steps = std::min<Eigen::Index>(Steps, b.size());
  for (Eigen::Index step = 0; step < steps; ++step)
  {
    Eigen::VectorXd next = A * vector;
    const double    alpha = next.dot(vector);
    matrix.diagonal.push_back(alpha);
    next -= alpha * vector + beta * previous;
    beta = next.norm();
    if (step + 1 == steps || beta < 1e-12 * std::abs(alpha))
    {
      break;
    }
    matrix.below.push_back(beta);
    previous = std::move(vector);
    vector = next / beta;
  }
  return matrix;
}
} // namespace

Eigen::VectorXd
SymmetricMatrix::operator*(const Eigen::VectorXd & x) const
{
  Eigen::VectorXd y = diagonal.cwiseProduct(x);
  for (const Entry & entry : entries)
  {
    y[entry.row] -= entry.weight * x[entry.column];
    y[entry.column] -= entry.weight * x[entry.row];
  }
  return y;
}

SpectralMeasure::SpectralMeasure(const SymmetricMatrix & A, const Eigen::VectorXd & b)
{
  const Tridiagonal                              matrix = Lanczos(A, b);
  const auto                                     size = static_cast<Eigen::Index>(matrix.diagonal.size());
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(matrix.diagonal.data(), size),
                                Eigen::Map<const Eigen::VectorXd>(matrix.below.data(), size - 1));
  m_Nodes = solver.eigenvalues().cwiseMax(0.0);
  m_Weights = b.squaredNorm() * solver.eigenvectors().row(0).transpose().cwiseAbs2();
}

double
SpectralMeasure::Remaining(double t) const
{
  double sum = 0.0;
  for (Eigen::Index i = 0; i < m_Nodes.size(); ++i)
  {
    sum += m_Weights[i] * std::exp(-t * m_Nodes[i]);
  }
  return sum;
}

double
SpectralMeasure::Gone(double t) const
{
  double sum = 0.0;
  for (Eigen::Index i = 0; i < m_Nodes.size(); ++i)
  {
    sum -= m_Weights[i] * std::expm1(-t * m_Nodes[i]);
  }
  return sum;
}
} // namespace shapeton
