#include "shapetonBeltramiEquations.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace shapeton
{
namespace
{
using Complex = std::complex<double>;

/** The matrix A of the equations. */
Eigen::Matrix2d
Conductivity(Complex mu)
{
  const double    r = mu.real();
  const double    t = mu.imag();
  Eigen::Matrix2d conductivity;
  conductivity << (r - 1) * (r - 1) + t * t, -2 * t, -2 * t, (1 + r) * (1 + r) + t * t;
  return conductivity / (1.0 - r * r - t * t);
}
} // namespace

BeltramiEquations::BeltramiEquations(std::vector<double> heights, int angles, double sourceAround, double targetAround)
  : m_Heights(std::move(heights)), m_Angles(angles), m_Width(sourceAround / angles), m_TargetAround(targetAround)
{
  if (m_Heights.empty() || angles < 3)
  {
    throw std::invalid_argument("a cylinder needs at least two rows of three nodes");
  }
}

BeltramiEquations::Triangle
BeltramiEquations::TriangleOf(int triangle) const
{
  const int  row = triangle / 2 / m_Angles;
  const int  angle = triangle / 2 % m_Angles;
  const int  next = (angle + 1) % m_Angles;
  const int  turned = next == 0;
  const bool isSecond = triangle % 2 != 0;
  return { { row * m_Angles + angle,
             (row + 1) * m_Angles + (isSecond ? next : angle),
             (row + (isSecond ? 0 : 1)) * m_Angles + next },
           { 0, isSecond ? turned : 0, turned } };
}

BeltramiEquations::Place
BeltramiEquations::PlaceOf(double row, double angle) const
{
  const int    i = std::clamp(static_cast<int>(row), 0, this->Rows() - 2);
  const int    j = std::clamp(static_cast<int>(angle), 0, m_Angles - 1);
  const double p = row - i;
  const double q = angle - j;
  const int    cell = i * m_Angles + j;
  return p >= q ? Place{ 2 * cell, { 1.0 - p, p - q, q } } : Place{ 2 * cell + 1, { 1.0 - q, p, q - p } };
}

double
BeltramiEquations::AreaOf(int triangle) const
{
  return 0.5 * m_Heights[triangle / 2 / m_Angles] * m_Width;
}

BeltramiEquations::Gradients
BeltramiEquations::GradientsOf(int triangle) const
{
  const double h = m_Heights[triangle / 2 / m_Angles];
  const double w = m_Width;
  Gradients    gradients;
  if (triangle % 2 == 0)
  {
    gradients << -1 / h, 1 / h, 0.0, 0.0, -1 / w, 1 / w;
  }
  else
  {
    gradients << 0.0, 1 / h, -1 / h, -1 / w, 0.0, 1 / w;
  }
  return gradients;
}

BeltramiEquations::Coefficients
BeltramiEquations::CoefficientsOf(const CylinderValues & values, int & flips) const
{
  Coefficients mu(this->Triangles());
  flips = 0;
  for (int t = 0; t < this->Triangles(); ++t)
  {
    const Triangle  triangle = this->TriangleOf(t);
    Eigen::Vector3d s, x;
    for (int k = 0; k < 3; ++k)
    {
      s[k] = values.along[triangle.node[k]];
      x[k] = values.around[triangle.node[k]] + triangle.turns[k] * m_TargetAround;
    }
    const Gradients       gradients = this->GradientsOf(t);
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

BeltramiEquations::System
BeltramiEquations::SystemOf(const Coefficients & mu) const
{
  const int                           nodes = this->Nodes();
  std::vector<Eigen::Triplet<double>> entries;
  System                              system{ Eigen::SparseMatrix<double>(nodes, nodes), Eigen::VectorXd::Zero(nodes) };
  for (int t = 0; t < this->Triangles(); ++t)
  {
    const Gradients       gradients = this->GradientsOf(t);
    const Eigen::Matrix3d local = this->AreaOf(t) * gradients.transpose() * Conductivity(mu[t]) * gradients;
    const Triangle        triangle = this->TriangleOf(t);
    for (int a = 0; a < 3; ++a)
    {
      for (int b = 0; b < 3; ++b)
      {
        entries.emplace_back(triangle.node[a], triangle.node[b], local(a, b));
        system.turn[triangle.node[a]] -= local(a, b) * triangle.turns[b] * m_TargetAround;
      }
    }
  }
  system.stiffness.setFromTriplets(entries.begin(), entries.end());
  return system;
}
} // namespace shapeton
