#include "shapetonSmoothCorrection.h"

#include "shapetonSparseCholesky.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shapeton
{
namespace
{
using SparseMatrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

/** Laplacian of a grid of rows (bounded) and angles (periodic), with weights 1 / distance^2. */
SparseMatrix
CylinderLaplacian(int rows, int angles, double rowStep, double angleStep)
{
  Triplets   entries;
  const auto join = [&entries](int a, int b, double weight) {
    entries.emplace_back(a, a, weight);
    entries.emplace_back(b, b, weight);
    entries.emplace_back(a, b, -weight);
    entries.emplace_back(b, a, -weight);
  };
  for (int i = 0; i < rows; ++i)
  {
    for (int j = 0; j < angles; ++j)
    {
      join(i * angles + j, i * angles + (j + 1) % angles, 1.0 / (angleStep * angleStep));
      if (i + 1 < rows)
      {
        join(i * angles + j, (i + 1) * angles + j, 1.0 / (rowStep * rowStep));
      }
    }
  }
  SparseMatrix laplacian(rows * angles, rows * angles);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}
} // namespace

SmoothCorrection::SmoothCorrection(double begin, double end, double around, const SmoothCorrectionOptions & options)
  : m_Options(options), m_Begin(begin), m_Around(around)
{
  m_Rows = std::max(2, static_cast<int>(std::ceil((end - begin) / options.step)) + 1);
  m_Values = Eigen::VectorXd::Zero(2 * m_Rows * options.angles);
}

SmoothCorrection::Stencil
SmoothCorrection::StencilAt(const CylinderPlace & place) const
{
  const int    angles = m_Options.angles;
  const double row = std::clamp((place.s - m_Begin) / m_Options.step, 0.0, m_Rows - 1.0);
  const double angle = (place.turn - std::floor(place.turn)) * angles;
  const int    i = std::min(static_cast<int>(row), m_Rows - 2);
  const int    j = static_cast<int>(angle);
  const double p = row - i;
  const double q = angle - j;
  const int    a = i * angles + j % angles;
  const int    b = i * angles + (j + 1) % angles;
  return { { a, b, a + angles, b + angles }, { (1 - p) * (1 - q), (1 - p) * q, p * (1 - q), p * q } };
}

Eigen::Vector2d
SmoothCorrection::At(const CylinderPlace & place) const
{
  const Stencil   stencil = this->StencilAt(place);
  const auto      nodes = m_Values.size() / 2;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int k = 0; k < 4; ++k)
  {
    sum += stencil.share[k] * Eigen::Vector2d(m_Values[stencil.node[k]], m_Values[nodes + stencil.node[k]]);
  }
  return sum;
}

void
SmoothCorrection::Solve(const std::vector<DisplacementConstraint> & constraints,
                        const std::vector<double> &                 weights,
                        const std::vector<DirectionConstraint> &    directions,
                        const std::vector<double> &                 directionWeights,
                        const Progress &                            progress)
{
  const int          nodes = m_Rows * m_Options.angles;
  const double       angleStep = m_Around / m_Options.angles;
  const SparseMatrix laplacian = CylinderLaplacian(m_Rows, m_Options.angles, m_Options.step, angleStep);
  const SparseMatrix bending =
    (m_Options.stiffness * laplacian * laplacian + m_Options.tension * laplacian) * (m_Options.step * angleStep);
  Triplets        entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * nodes);
  const auto add = [&](const CylinderPlace & place, const Eigen::Vector2d & direction, double value, double weight) {
    const Stencil stencil = this->StencilAt(place);
    for (int k = 0; k < 8; ++k)
    {
      const int    row = stencil.node[k % 4] + (k / 4) * nodes;
      const double share = stencil.share[k % 4] * direction[k / 4];
      right[row] += weight * share * value;
      for (int l = 0; l < 8 && share != 0.0; ++l)
      {
        const double other = stencil.share[l % 4] * direction[l / 4];
        if (other != 0.0)
        {
          entries.emplace_back(row, stencil.node[l % 4] + (l / 4) * nodes, weight * share * other);
        }
      }
    }
  };
  for (int k = 0; k < bending.outerSize(); ++k)
  {
    for (SparseMatrix::InnerIterator it(bending, k); it; ++it)
    {
      entries.emplace_back(it.row(), it.col(), it.value());
      entries.emplace_back(it.row() + nodes, it.col() + nodes, it.value());
    }
  }
  for (int node = 0; node < 2 * nodes; ++node)
  {
    constexpr double noDrift = 1e-6; // decay to 0 far from all constraints
    entries.emplace_back(node, node, noDrift);
  }
  for (std::size_t i = 0; i < constraints.size(); ++i)
  {
    const double weight = weights[i] / (m_Options.deviation * m_Options.deviation);
    add(constraints[i].place, Eigen::Vector2d::UnitX(), constraints[i].displacement.x(), weight);
    add(constraints[i].place, Eigen::Vector2d::UnitY(), constraints[i].displacement.y(), weight);
  }
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    add(directions[i].place, directions[i].direction, directions[i].value, directionWeights[i]);
  }
  SparseMatrix system(2 * nodes, 2 * nodes);
  system.setFromTriplets(entries.begin(), entries.end());
  if (!SolvePositiveDefinite(system, right, progress))
  {
    throw std::runtime_error("the linear system of the smooth correction is singular");
  }
  m_Values = right;
}

std::vector<double>
SmoothCorrection::Fit(const std::vector<DisplacementConstraint> & constraints,
                      const std::vector<DirectionConstraint> &    directions,
                      const Progress &                            progress)
{
  std::vector<double> weights;
  std::vector<double> directionWeights;
  for (const DisplacementConstraint & constraint : constraints)
  {
    weights.push_back(constraint.weight);
  }
  for (const DirectionConstraint & direction : directions)
  {
    directionWeights.push_back(direction.weight);
  }
  const auto cauchy = [this](double error) { return 1.0 / (1.0 + std::pow(error / m_Options.robust, 2)); };
  for (int iteration = 0; iteration < m_Options.iterations; ++iteration)
  {
    const double begin = static_cast<double>(iteration) / m_Options.iterations;
    const double end = (iteration + 1.0) / m_Options.iterations;
    progress(begin);
    this->Solve(constraints, weights, directions, directionWeights, progress.Part("", begin, end));
    for (std::size_t i = 0; i < constraints.size(); ++i)
    {
      weights[i] =
        constraints[i].weight * cauchy((this->At(constraints[i].place) - constraints[i].displacement).norm());
    }
    for (std::size_t i = 0; i < directions.size(); ++i)
    {
      const double error = this->At(directions[i].place).dot(directions[i].direction) - directions[i].value;
      directionWeights[i] = directions[i].weight * (directions[i].isRobust ? cauchy(error) : 1.0);
    }
  }
  return weights;
}
} // namespace shapeton
