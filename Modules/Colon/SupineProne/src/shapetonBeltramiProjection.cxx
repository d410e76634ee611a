#include "shapetonBeltramiProjection.h"

#include "shapetonBeltramiEquations.h"
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
using Coefficients = BeltramiEquations::Coefficients;

/** Values in mm, with the ends projected to circles. */
CylinderValues
ValuesOf(const CylinderNodes & nodes, double targetAround)
{
  const int      angles = nodes.Angles();
  CylinderValues values;
  values.along = Eigen::Map<const Eigen::VectorXd>(Eigen::MatrixXd(nodes.s.transpose()).data(), nodes.s.size());
  values.around = Eigen::Map<const Eigen::VectorXd>(Eigen::MatrixXd(nodes.turn.transpose()).data(), nodes.s.size());
  values.around *= targetAround;
  values.along.head(angles).setConstant(values.along.head(angles).mean());
  values.along.tail(angles).setConstant(values.along.tail(angles).mean());
  return values;
}

/** Replaces clamped coefficients by the mean over the adjacent triangles. */
void
Smooth(const BeltramiEquations & equations, const std::vector<char> & isCut, Coefficients & mu)
{
  std::vector<Complex> sum(equations.Nodes());
  std::vector<int>     number(equations.Nodes(), 0);
  for (std::size_t t = 0; t < mu.size(); ++t)
  {
    for (const int corner : equations.TriangleOf(static_cast<int>(t)).node)
    {
      sum[corner] += mu[t];
      ++number[corner];
    }
  }
  for (std::size_t t = 0; t < mu.size(); ++t)
  {
    if (isCut[t])
    {
      mu[t] = 0.0;
      for (const int corner : equations.TriangleOf(static_cast<int>(t)).node)
      {
        mu[t] += sum[corner] / (3.0 * number[corner]);
      }
    }
  }
}

/** Clamps coefficients to `greatest` and averages over their neighborhood; returns false if no coefficient was too
 * large. */
bool
Bound(const BeltramiEquations & equations, double greatest, Coefficients & mu)
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
  constexpr int passes = 2; // chosen: mixes cut coefficients with two rings of neighbors
  for (int pass = 0; pass < passes && isAny; ++pass)
  {
    Smooth(equations, isCut, mu);
  }
  return isAny;
}

/** Solves stiffness * values = right with the first and last `ends` nodes fixed (only the first one for 0). */
void
SolveWithFixed(const Eigen::SparseMatrix<double> & stiffness, Eigen::VectorXd right, int ends, Eigen::VectorXd & values)
{
  const int       nodes = static_cast<int>(values.size());
  const int       first = std::max(1, ends);
  const int       inner = nodes - first - ends;
  Eigen::VectorXd fixed = values;
  fixed.segment(first, inner).setZero();
  right -= stiffness * fixed;
  if (!SolvePositiveDefinite(stiffness.block(first, first, inner, inner), right.segment(first, inner)))
  {
    throw std::runtime_error("the linear system of the Beltrami solver is singular");
  }
  values.segment(first, inner) = right.segment(first, inner);
}

/** The map for these coefficients, with the overall rotation of the previous map. */
void
Solve(const BeltramiEquations & equations, const Coefficients & mu, CylinderValues & values)
{
  const BeltramiEquations::System system = equations.SystemOf(mu);
  const double                    meanBefore = values.around.mean();
  SolveWithFixed(system.stiffness, Eigen::VectorXd::Zero(equations.Nodes()), equations.Angles(), values.along);
  SolveWithFixed(system.stiffness, system.turn, 0, values.around);
  values.around.array() += meanBefore - values.around.mean();
}

CylinderNodes
NodesOf(const CylinderValues & values, double targetAround, CylinderNodes like)
{
  const int angles = like.Angles();
  for (int i = 0; i < like.Rows(); ++i)
  {
    like.s.row(i) = values.along.segment(i * angles, angles).transpose();
    like.turn.row(i) = values.around.segment(i * angles, angles).transpose() / targetAround;
  }
  return like;
}

double
GreatestOf(const Coefficients & mu)
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
  const BeltramiEquations equations(
    std::vector<double>(nodes.Rows() - 1, nodes.step), nodes.Angles(), sourceAround, targetAround);
  CylinderValues     values = ValuesOf(nodes, targetAround);
  BeltramiProjection projection;
  Coefficients       mu = equations.CoefficientsOf(values, projection.flipsBefore);
  projection.greatestBefore = GreatestOf(mu);
  projection.flips = projection.flipsBefore;
  double bound = options.greatest;
  while (projection.iterations < options.iterations && Bound(equations, bound, mu))
  {
    Solve(equations, mu, values);
    options.progress((projection.iterations + 1.0) / options.iterations);
    mu = equations.CoefficientsOf(values, projection.flips);
    ++projection.iterations;
    constexpr double tighter = 0.9; // factor of the bound while triangles are inverted; chosen
    bound *= projection.flips > 0 ? tighter : 1.0;
    if (projection.flips == 0 && GreatestOf(mu) < 0.5 * (1.0 + options.greatest))
    {
      break; // a bijection with coefficients slightly above the bound is accepted
    }
  }
  projection.greatest = GreatestOf(mu);
  projection.nodes = NodesOf(values, targetAround, nodes);
  return projection;
}
} // namespace shapeton
