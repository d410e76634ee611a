#include "shapetonPolygonTriangulation.h"
#include "shapetonTriangleShape.h"

#include <Eigen/Geometry>

namespace shapeton
{
namespace
{
/** Polygon normal by Newell's method. */
Eigen::Vector3d
NormalOf(const std::vector<Eigen::Vector3d> & corners)
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    normal += (corners[i] - corners[0]).cross(corners[(i + 1) % corners.size()] - corners[0]);
  }
  return normal;
}

class EarCutter
{
public:
  explicit EarCutter(const std::vector<Eigen::Vector3d> & corners) : m_Corners(corners), m_Normal(NormalOf(corners))
  {
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      m_Ring.push_back(static_cast<int>(i));
    }
  }

  std::vector<std::array<int, 3>>
  Cut()
  {
    std::vector<std::array<int, 3>> triangles;
    while (m_Ring.size() > 3)
    {
      const std::size_t ear = this->BestEar();
      triangles.push_back(this->TriangleAt(ear));
      m_Ring.erase(m_Ring.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({ m_Ring[0], m_Ring[1], m_Ring[2] });
    return triangles;
  }

private:
  std::array<int, 3>
  TriangleAt(std::size_t i) const
  {
    const std::size_t n = m_Ring.size();
    return { m_Ring[(i + n - 1) % n], m_Ring[i], m_Ring[(i + 1) % n] };
  }

  bool
  IsEar(const std::array<int, 3> & t) const
  {
    const Eigen::Vector3d & a = m_Corners[t[0]];
    const Eigen::Vector3d & b = m_Corners[t[1]];
    const Eigen::Vector3d & c = m_Corners[t[2]];
    if (!(DoubleAreaNormal(a, b, c).dot(m_Normal) > 0.0))
    {
      return false;
    }
    for (const int i : m_Ring)
    {
      const Eigen::Vector3d & p = m_Corners[i];
      if (i != t[0] && i != t[1] && i != t[2] && DoubleAreaNormal(a, b, p).dot(m_Normal) >= 0.0 &&
          DoubleAreaNormal(b, c, p).dot(m_Normal) >= 0.0 && DoubleAreaNormal(c, a, p).dot(m_Normal) >= 0.0)
      {
        return false;
      }
    }
    return true;
  }

  std::size_t
  BestEar() const
  {
    std::size_t best = 1; // a fan, if there are no ears
    double      leastCosine = 2.0;
    for (std::size_t i = 0; i < m_Ring.size(); ++i)
    {
      const auto   t = this->TriangleAt(i);
      const double cosine = CosineOfSmallestAngle(m_Corners[t[0]], m_Corners[t[1]], m_Corners[t[2]]);
      if (cosine < leastCosine && this->IsEar(t))
      {
        leastCosine = cosine;
        best = i;
      }
    }
    return best;
  }

  const std::vector<Eigen::Vector3d> & m_Corners;
  Eigen::Vector3d                      m_Normal;
  std::vector<int>                     m_Ring;
};
} // namespace

std::vector<std::array<int, 3>>
TriangulatePolygon(const std::vector<Eigen::Vector3d> & corners)
{
  if (corners.size() < 3)
  {
    return {};
  }
  return EarCutter(corners).Cut();
}
} // namespace shapeton
