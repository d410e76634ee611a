#include "shapetonTorusInSpace.h"

#include "shapetonPathsOfEdges.h"
#include "shapetonPi.h"

#include <cmath>

namespace shapeton
{
namespace
{
using Complex = std::complex<double>;
} // namespace

TorusInSpace::TorusInSpace(const EmbeddingCertificate & certificate)
  : m_Certificate(certificate)
  , m_W1(certificate.periods.at(0), certificate.periods.at(1))
  , m_W2(certificate.periods.at(2), certificate.periods.at(3))
{
  const Complex ratio = m_W2 / m_W1;
  const Complex rectangle(0.0, std::abs(ratio));
  const double  k = std::abs((ratio - rectangle) / (ratio - std::conj(rectangle)));
  m_Dilatation = (1.0 + k) / (1.0 - k);
  m_TubeRadius = 1.0 / std::sqrt(1.0 + std::norm(ratio));
}

std::array<double, 2>
TorusInSpace::Coordinates(const Complex & z) const
{
  const double area = (std::conj(m_W1) * m_W2).imag();
  return { (std::conj(z) * m_W2).imag() / area, (std::conj(m_W1) * z).imag() / area };
}

TorusInSpace::Point
TorusInSpace::operator()(const Complex & z) const
{
  const auto [s, t] = this->Coordinates(z);
  const double u = -2.0 * Pi * t; // keeps the orientation as seen from outside
  const double r = m_TubeRadius;
  const double v = 2.0 * std::atan2(std::sqrt(1.0 + r) * std::sin(Pi * s), std::sqrt(1.0 - r) * std::cos(Pi * s));
  const double distance = 1.0 + r * std::cos(v);
  return { distance * std::cos(u), distance * std::sin(u), r * std::sin(v) };
}

Complex
TorusInSpace::Place(int node) const
{
  return { m_Certificate.nodePositions[2 * node], m_Certificate.nodePositions[2 * node + 1] };
}

/** Vector along an edge, to the lift of its end at which the circles of both nodes are tangent. */
Complex
TorusInSpace::Along(int halfEdge) const
{
  const auto &  ends = m_Certificate.packed.edges[halfEdge / 2];
  const int     from = ends[halfEdge % 2];
  const int     to = ends[1 - halfEdge % 2];
  const double  length = m_Certificate.nodeRadii[from] + m_Certificate.nodeRadii[to];
  const Complex difference = this->Place(to) - this->Place(from);
  const auto    whole = this->Coordinates(difference);
  const Complex nearest = difference - std::round(whole[0]) * m_W1 - std::round(whole[1]) * m_W2;
  Complex       best = nearest;
  for (int i = -2; i <= 2; ++i)
  {
    for (int j = -2; j <= 2; ++j)
    {
      const Complex candidate = nearest + static_cast<double>(i) * m_W1 + static_cast<double>(j) * m_W2;
      best = std::abs(std::abs(candidate) - length) < std::abs(std::abs(best) - length) ? candidate : best;
    }
  }
  return best;
}

std::vector<Complex>
TorusInSpace::FlatNodes() const
{
  std::vector<Complex> nodes;
  for (int node = 0; node < m_Certificate.graph.nodes; ++node)
  {
    nodes.push_back(this->Place(node));
  }
  return nodes;
}

std::vector<std::vector<Complex>>
TorusInSpace::FlatEdges(int pieces) const
{
  const auto                        paths = PathsOfEdges(m_Certificate.graph.edges.size(), m_Certificate.subdivided);
  std::vector<std::vector<Complex>> curves(paths.size());
  for (std::size_t edge = 0; edge < paths.size(); ++edge)
  {
    Complex start = this->Place(m_Certificate.packed.edges[paths[edge].front() / 2][paths[edge].front() % 2]);
    for (const int h : paths[edge])
    {
      const Complex along = this->Along(h);
      for (int i = curves[edge].empty() ? 0 : 1; i <= pieces; ++i)
      {
        curves[edge].push_back(start + along * (static_cast<double>(i) / pieces));
      }
      start += along;
    }
  }
  return curves;
}

std::vector<TorusInSpace::Point>
TorusInSpace::Nodes() const
{
  std::vector<Point> nodes;
  for (const Complex & place : this->FlatNodes())
  {
    nodes.push_back((*this)(place));
  }
  return nodes;
}

std::vector<std::vector<TorusInSpace::Point>>
TorusInSpace::Edges(int pieces) const
{
  std::vector<std::vector<Point>> curves;
  for (const std::vector<Complex> & flat : this->FlatEdges(pieces))
  {
    curves.emplace_back();
    for (const Complex & place : flat)
    {
      curves.back().push_back((*this)(place));
    }
  }
  return curves;
}
} // namespace shapeton
