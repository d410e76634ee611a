#include "shapetonSurfaceLocator.h"
#include "shapetonParallelFor.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace shapeton
{
namespace
{
constexpr int FacesOfLeaf = 4; // of the tree; chosen

int
NumberOfNodes(int faces)
{
  return faces <= FacesOfLeaf ? 1 : 1 + NumberOfNodes(faces / 2) + NumberOfNodes(faces - faces / 2);
}

Eigen::Vector3d
ClosestPointOfSegment(const Eigen::Vector3d & p, const Eigen::Vector3d & a, const Eigen::Vector3d & b)
{
  const Eigen::Vector3d direction = b - a;
  const double          square = direction.squaredNorm();
  const double          place = square > 0.0 ? (p - a).dot(direction) / square : 0.0;
  return a + std::clamp(place, 0.0, 1.0) * direction;
}

/** Closest point on the three sides; for a zero-area triangle. */
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
  const double          sum = va + vb + vc; // squared double area
  constexpr double      degenerate = 1e-24; // squared sine of the angle
  if (va > 0.0 && vb > 0.0 && vc > 0.0 && sum > degenerate * ab.squaredNorm() * ac.squaredNorm())
  {
    return a + (vb / sum) * ab + (vc / sum) * ac;
  }
  return ClosestPointOfSides(p, a, b, c);
}

SurfaceLocator::SurfaceLocator(const VertexMatrix & V, const FaceMatrix & F) : m_V(V), m_F(F), m_Order(F.rows())
{
  if (F.rows() == 0 || F.minCoeff() < 0 || F.maxCoeff() >= V.rows())
  {
    throw std::invalid_argument("SurfaceLocator: no faces, or an index is out of range");
  }
  std::iota(m_Order.begin(), m_Order.end(), 0);
  VertexMatrix centers(F.rows(), 3);
  for (int f = 0; f < F.rows(); ++f)
  {
    centers.row(f) = (V.row(F(f, 0)) + V.row(F(f, 1)) + V.row(F(f, 2))) / 3.0;
  }
  m_Nodes.resize(NumberOfNodes(static_cast<int>(F.rows())));
  this->BuildTop(centers);
}

SurfaceLocator::~SurfaceLocator() = default;

/** Splits the tree into parts that are built in parallel. Node positions are the same as with one thread. */
void
SurfaceLocator::BuildTop(const VertexMatrix & centers)
{
  constexpr int     levels = 5;
  std::vector<Part> parts{ { 0, 0, static_cast<int>(m_Order.size()) } };
  for (int level = 0; level < levels; ++level)
  {
    std::vector<Part> halves(2 * parts.size(), Part{ 0, 0, 0 }); // empty if a part is a leaf
    ParallelFor(parts.size(), [&](std::size_t i) {
      const Part & part = parts[i];
      const int    middle = this->Split(part, centers);
      if (middle > part.begin)
      {
        const int right = part.node + 1 + NumberOfNodes(middle - part.begin);
        m_Nodes[part.node].right = right;
        halves[2 * i] = { part.node + 1, part.begin, middle };
        halves[2 * i + 1] = { right, middle, part.end };
      }
    });
    const auto isEmpty = [](const Part & part) { return part.begin == part.end; };
    halves.erase(std::remove_if(halves.begin(), halves.end(), isEmpty), halves.end());
    parts.swap(halves);
  }
  ParallelFor(parts.size(), [&](std::size_t i) { this->Build(parts[i], centers); });
}

/** Sets the first node of a part and splits its faces into halves. Returns the start of the second half; for a leaf,
 * the start of the part. */
int
SurfaceLocator::Split(const Part & part, const VertexMatrix & centers)
{
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;
  for (int i = part.begin; i < part.end; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      low = low.cwiseMin(m_V.row(m_F(m_Order[i], k)).transpose());
      high = high.cwiseMax(m_V.row(m_F(m_Order[i], k)).transpose());
    }
  }
  m_Nodes[part.node] = { low, high, part.begin, part.end, 0 };
  if (part.end - part.begin <= FacesOfLeaf)
  {
    return part.begin;
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const int  middle = part.begin + (part.end - part.begin) / 2;
  const auto order = m_Order.begin();
  std::nth_element(order + part.begin, order + middle, order + part.end, [&](int a, int b) {
    return centers(a, axis) != centers(b, axis) ? centers(a, axis) < centers(b, axis) : a < b;
  });
  return middle;
}

/** The node after the end of the subtree. */
int
SurfaceLocator::Build(const Part & part, const VertexMatrix & centers)
{
  const int middle = this->Split(part, centers);
  if (middle == part.begin)
  {
    return part.node + 1;
  }
  const int right = this->Build({ part.node + 1, part.begin, middle }, centers);
  m_Nodes[part.node].right = right;
  return this->Build({ right, middle, part.end }, centers);
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
  constexpr double farthest = 1e70; // products of four distances stay finite
  if (!p.allFinite())
  {
    throw std::invalid_argument("SurfaceLocator: a position is not finite");
  }
  Closest best;
  double  bestSquare = std::numeric_limits<double>::infinity();
  this->Search(0, p.cwiseMax(-farthest).cwiseMin(farthest), best, bestSquare);
  best.distance = std::sqrt(bestSquare);
  return best;
}
} // namespace shapeton
