#include "shapetonSurfaceLocator.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace shapeton
{
namespace
{
constexpr int FacesOfLeaf = 4;

Eigen::Vector3d
ClosestPointOfSegment(const Eigen::Vector3d & p, const Eigen::Vector3d & a, const Eigen::Vector3d & b)
{
  const Eigen::Vector3d direction = b - a;
  const double          square = direction.squaredNorm();
  const double          place = square > 0.0 ? (p - a).dot(direction) / square : 0.0;
  return a + std::clamp(place, 0.0, 1.0) * direction;
}

/** The closest of the three sides; for a triangle without area. */
Eigen::Vector3d
ClosestPointOfSides(const Eigen::Vector3d & p,
                    const Eigen::Vector3d & a,
                    const Eigen::Vector3d & b,
                    const Eigen::Vector3d & c)
{
  Eigen::Vector3d best = ClosestPointOfSegment(p, a, b);
  for (const Eigen::Vector3d & other : { ClosestPointOfSegment(p, b, c), ClosestPointOfSegment(p, c, a) })
  {
    best = (other - p).squaredNorm() < (best - p).squaredNorm() ? other : best;
  }
  return best;
}
} // namespace

Eigen::Vector3d
ClosestPointOfTriangle(const Eigen::Vector3d & p,
                       const Eigen::Vector3d & a,
                       const Eigen::Vector3d & b,
                       const Eigen::Vector3d & c)
{
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const double          d1 = ab.dot(p - a);
  const double          d2 = ac.dot(p - a);
  const double          d3 = ab.dot(p - b);
  const double          d4 = ac.dot(p - b);
  const double          d5 = ab.dot(p - c);
  const double          d6 = ac.dot(p - c);
  const double          va = d3 * d6 - d5 * d4;
  const double          vb = d5 * d2 - d1 * d6;
  const double          vc = d1 * d4 - d3 * d2;
  const double          sum = va + vb + vc; // the square of twice the area
  if (va > 0.0 && vb > 0.0 && vc > 0.0 && sum > 1e-24 * ab.squaredNorm() * ac.squaredNorm())
  {
    return a + (vb / sum) * ab + (vc / sum) * ac;
  }
  return ClosestPointOfSides(p, a, b, c);
}

SurfaceLocator::SurfaceLocator(const VertexMatrix & V, const FaceMatrix & F) : m_V(V), m_F(F), m_Order(F.rows())
{
  if (F.rows() == 0 || F.minCoeff() < 0 || F.maxCoeff() >= V.rows())
  {
    throw std::invalid_argument("SurfaceLocator: there is no face, or an index is out of range");
  }
  std::iota(m_Order.begin(), m_Order.end(), 0);
  VertexMatrix centres(F.rows(), 3);
  for (int f = 0; f < F.rows(); ++f)
  {
    centres.row(f) = (V.row(F(f, 0)) + V.row(F(f, 1)) + V.row(F(f, 2))) / 3.0;
  }
  this->Build(0, static_cast<int>(F.rows()), centres);
}

SurfaceLocator::~SurfaceLocator() = default;

int
SurfaceLocator::Build(int begin, int end, const VertexMatrix & centres)
{
  const int       index = static_cast<int>(m_Nodes.size());
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;
  for (int i = begin; i < end; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      low = low.cwiseMin(m_V.row(m_F(m_Order[i], k)).transpose());
      high = high.cwiseMax(m_V.row(m_F(m_Order[i], k)).transpose());
    }
  }
  m_Nodes.push_back({ low, high, begin, end, 0 });
  if (end - begin <= FacesOfLeaf)
  {
    return index;
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const int middle = begin + (end - begin) / 2;
  std::nth_element(m_Order.begin() + begin, m_Order.begin() + middle, m_Order.begin() + end, [&](int a, int b) {
    return centres(a, axis) != centres(b, axis) ? centres(a, axis) < centres(b, axis) : a < b;
  });
  this->Build(begin, middle, centres);
  const int right = this->Build(middle, end, centres);
  m_Nodes[index].right = right;
  return index;
}

double
SurfaceLocator::SquareDistanceToBox(int node, const Eigen::Vector3d & p) const
{
  return (m_Nodes[node].low - p).cwiseMax(p - m_Nodes[node].high).cwiseMax(0.0).squaredNorm();
}

void
SurfaceLocator::Search(int node, const Eigen::Vector3d & p, Closest & best, double & bestSquare) const
{
  const Node & here = m_Nodes[node];
  if (here.right == 0)
  {
    for (int i = here.begin; i < here.end; ++i)
    {
      const int             f = m_Order[i];
      const Eigen::Vector3d point =
        ClosestPointOfTriangle(p, m_V.row(m_F(f, 0)), m_V.row(m_F(f, 1)), m_V.row(m_F(f, 2)));
      const double square = (point - p).squaredNorm();
      if (square < bestSquare || (square == bestSquare && f < best.face))
      {
        bestSquare = square;
        best.point = point;
        best.face = f;
      }
    }
    return;
  }
  int    near = node + 1;
  int    far = here.right;
  double nearSquare = this->SquareDistanceToBox(near, p);
  double farSquare = this->SquareDistanceToBox(far, p);
  if (farSquare < nearSquare)
  {
    std::swap(near, far);
    std::swap(nearSquare, farSquare);
  }
  if (nearSquare <= bestSquare)
  {
    this->Search(near, p, best, bestSquare);
  }
  if (farSquare <= bestSquare)
  {
    this->Search(far, p, best, bestSquare);
  }
}

SurfaceLocator::Closest
SurfaceLocator::FindClosest(const Eigen::Vector3d & p) const
{
  Closest best;
  double  bestSquare = std::numeric_limits<double>::infinity();
  this->Search(0, p, best, bestSquare);
  best.distance = std::sqrt(bestSquare);
  return best;
}
} // namespace shapeton
