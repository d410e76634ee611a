#include "shapetonHolePatch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace shapeton
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int    mostFlipRounds = 20;            // chosen; bounds the time
constexpr double root2 = 1.41421356237309504880; // ratio of sizes in the criterion of Liepa (2003)

double
Cotangent(const Eigen::Vector3d & apex, const Eigen::Vector3d & a, const Eigen::Vector3d & b)
{
  const Eigen::Vector3d u = a - apex;
  const Eigen::Vector3d v = b - apex;
  return u.dot(v) / std::max(u.cross(v).norm(), 1e-300);
}
} // namespace

HolePatch::HolePatch(std::vector<Eigen::Vector3d>  rim,
                     std::vector<double>           scales,
                     std::function<bool(int, int)> isTaken)
  : m_Rim(static_cast<int>(rim.size()))
  , m_Points(std::move(rim))
  , m_Scales(std::move(scales))
  , m_IsTaken(std::move(isTaken))
{}

double
HolePatch::LeastArea(std::vector<int> & middles) const
{
  std::vector<double> areas(static_cast<std::size_t>(m_Rim) * m_Rim, 0.0);
  for (int span = 2; span < m_Rim; ++span)
  {
    for (int first = 0; first + span < m_Rim; ++first)
    {
      const int last = first + span;
      double &  best = areas[first * m_Rim + last];
      best = infinity;
      if (span < m_Rim - 1 && m_IsTaken(first, last))
      {
        continue;
      }
      for (int middle = first + 1; middle < last; ++middle)
      {
        const double own = 0.5 * (m_Points[middle] - m_Points[first]).cross(m_Points[last] - m_Points[first]).norm();
        const double sum = areas[first * m_Rim + middle] + areas[middle * m_Rim + last] + own;
        if (sum < best)
        {
          best = sum;
          middles[first * m_Rim + last] = middle;
        }
      }
    }
  }
  return areas[m_Rim - 1];
}

void
HolePatch::AddFaces(const std::vector<int> & middles, int first, int last)
{
  if (last - first < 2)
  {
    return;
  }
  const int middle = middles[first * m_Rim + last];
  m_Faces.push_back({ { first, middle, last }, { -1, -1, -1 } });
  this->AddFaces(middles, first, middle);
  this->AddFaces(middles, middle, last);
}

bool
HolePatch::Triangulate()
{
  std::vector<int> middles(static_cast<std::size_t>(m_Rim) * m_Rim, -1);
  if (m_Rim < 3 || !(this->LeastArea(middles) < infinity))
  {
    return false;
  }
  this->AddFaces(middles, 0, m_Rim - 1);
  this->Connect();
  this->FlipAll();
  return true;
}

void
HolePatch::Connect()
{
  std::map<std::pair<int, int>, std::pair<int, int>> sides;
  for (int f = 0; f < static_cast<int>(m_Faces.size()); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = m_Faces[f].corners[k];
      const int b = m_Faces[f].corners[(k + 1) % 3];
      sides[{ a, b }] = { f, k };
      const auto other = sides.find({ b, a });
      if (other != sides.end())
      {
        m_Faces[f].neighbors[k] = other->second.first;
        m_Faces[other->second.first].neighbors[other->second.second] = f;
      }
    }
  }
}

bool
HolePatch::IsTooLarge(const Face & face) const
{
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double          scale = 0.0;
  for (const int v : face.corners)
  {
    center += m_Points[v] / 3.0;
    scale += m_Scales[v] / 3.0;
  }
  return std::all_of(face.corners.begin(), face.corners.end(), [&](int v) {
    return root2 * (center - m_Points[v]).norm() > std::max(scale, m_Scales[v]);
  });
}

void
HolePatch::ReplaceNeighbor(int face, int before, int after)
{
  if (face != -1)
  {
    auto & neighbors = m_Faces[face].neighbors;
    *std::find(neighbors.begin(), neighbors.end(), before) = after;
  }
}

void
HolePatch::Split(int face)
{
  const Face before = m_Faces[face];
  const int  center = static_cast<int>(m_Points.size());
  const auto & [a, b, c] = before.corners;
  m_Points.push_back((m_Points[a] + m_Points[b] + m_Points[c]) / 3.0);
  m_Scales.push_back((m_Scales[a] + m_Scales[b] + m_Scales[c]) / 3.0);
  const int second = static_cast<int>(m_Faces.size());
  const int third = second + 1;
  m_Faces[face] = { { a, b, center }, { before.neighbors[0], second, third } };
  m_Faces.push_back({ { b, c, center }, { before.neighbors[1], third, face } });
  m_Faces.push_back({ { c, a, center }, { before.neighbors[2], face, second } });
  this->ReplaceNeighbor(before.neighbors[1], face, second);
  this->ReplaceNeighbor(before.neighbors[2], face, third);
}

bool
HolePatch::HasEdge(int a, int b) const
{
  return std::any_of(m_Faces.begin(), m_Faces.end(), [&](const Face & face) {
    const auto has = [&](int v) {
      return std::find(face.corners.begin(), face.corners.end(), v) != face.corners.end();
    };
    return has(a) && has(b);
  });
}

/** Replaces the edge a b of the faces a b c and b a d by c d if the angles at c and d sum to more than 180 degrees. */
bool
HolePatch::FlipIfBetter(int face, int k)
{
  const int other = m_Faces[face].neighbors[k];
  if (other == -1)
  {
    return false;
  }
  const auto & neighbors = m_Faces[other].neighbors;
  const int    j = static_cast<int>(std::find(neighbors.begin(), neighbors.end(), face) - neighbors.begin());
  const int    a = m_Faces[face].corners[k];
  const int    b = m_Faces[face].corners[(k + 1) % 3];
  const int    c = m_Faces[face].corners[(k + 2) % 3];
  const int    d = m_Faces[other].corners[(j + 2) % 3];
  const double sum =
    Cotangent(m_Points[c], m_Points[a], m_Points[b]) + Cotangent(m_Points[d], m_Points[a], m_Points[b]);
  if (!(sum < -1e-9) || (std::max(c, d) < m_Rim && m_IsTaken(c, d)) || this->HasEdge(c, d))
  {
    return false;
  }
  const int bc = m_Faces[face].neighbors[(k + 1) % 3];
  const int ca = m_Faces[face].neighbors[(k + 2) % 3];
  const int ad = m_Faces[other].neighbors[(j + 1) % 3];
  const int db = m_Faces[other].neighbors[(j + 2) % 3];
  m_Faces[face] = { { c, d, b }, { other, db, bc } };
  m_Faces[other] = { { d, c, a }, { face, ca, ad } };
  this->ReplaceNeighbor(db, other, face);
  this->ReplaceNeighbor(ca, face, other);
  return true;
}

void
HolePatch::FlipAll()
{
  bool hasFlipped = true;
  for (int round = 0; hasFlipped && round < mostFlipRounds; ++round)
  {
    hasFlipped = false;
    for (int f = 0; f < static_cast<int>(m_Faces.size()); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        hasFlipped = this->FlipIfBetter(f, k) || hasFlipped;
      }
    }
  }
}

void
HolePatch::Refine()
{
  for (int round = 0; round < mostFlipRounds; ++round)
  {
    const int number = static_cast<int>(m_Faces.size());
    for (int f = 0; f < number; ++f)
    {
      if (this->IsTooLarge(m_Faces[f]))
      {
        this->Split(f);
      }
    }
    if (static_cast<int>(m_Faces.size()) == number)
    {
      return;
    }
    this->FlipAll();
  }
}

std::vector<std::array<int, 3>>
HolePatch::Faces() const
{
  std::vector<std::array<int, 3>> faces;
  for (const Face & face : m_Faces)
  {
    faces.push_back(face.corners);
  }
  return faces;
}
} // namespace shapeton
