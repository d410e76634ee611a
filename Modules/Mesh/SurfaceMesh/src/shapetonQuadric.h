#ifndef shapetonQuadric_h
#define shapetonQuadric_h

#include <Eigen/Core>

namespace shapeton
{
/** A sum of weighted squared distances to planes and points: p A p + 2 b p + c. */
class Quadric
{
public:
  /** Adds weight times the squared distance to the plane through `point` with the unit normal `normal`. */
  void
  AddPlane(const Eigen::Vector3d & point, const Eigen::Vector3d & normal, double weight)
  {
    const double offset = -normal.dot(point);
    m_A[0] += weight * normal[0] * normal[0];
    m_A[1] += weight * normal[0] * normal[1];
    m_A[2] += weight * normal[0] * normal[2];
    m_A[3] += weight * normal[1] * normal[1];
    m_A[4] += weight * normal[1] * normal[2];
    m_A[5] += weight * normal[2] * normal[2];
    m_B += weight * offset * normal;
    m_C += weight * offset * offset;
  }

  /** Adds weight times the squared distance to a point. */
  void
  AddPoint(const Eigen::Vector3d & point, double weight)
  {
    m_A[0] += weight;
    m_A[3] += weight;
    m_A[5] += weight;
    m_B -= weight * point;
    m_C += weight * point.squaredNorm();
  }

  Quadric &
  operator+=(const Quadric & other)
  {
    for (int i = 0; i < 6; ++i)
    {
      m_A[i] += other.m_A[i];
    }
    m_B += other.m_B;
    m_C += other.m_C;
    return *this;
  }

  double
  At(const Eigen::Vector3d & p) const
  {
    return p.dot(this->Multiply(p) + 2.0 * m_B) + m_C;
  }

  /** Computes the point with the smallest value; returns false if the planes and points do not determine it well. */
  bool
  Minimize(Eigen::Vector3d & p) const
  {
    const double c00 = m_A[3] * m_A[5] - m_A[4] * m_A[4];
    const double c01 = m_A[2] * m_A[4] - m_A[1] * m_A[5];
    const double c02 = m_A[1] * m_A[4] - m_A[2] * m_A[3];
    const double determinant = m_A[0] * c00 + m_A[1] * c01 + m_A[2] * c02;
    const double scale = m_A[0] + m_A[3] + m_A[5];
    if (!(determinant > 1e-12 * scale * scale * scale))
    {
      return false;
    }
    const double c11 = m_A[0] * m_A[5] - m_A[2] * m_A[2];
    const double c12 = m_A[1] * m_A[2] - m_A[0] * m_A[4];
    const double c22 = m_A[0] * m_A[3] - m_A[1] * m_A[1];
    p[0] = -(c00 * m_B[0] + c01 * m_B[1] + c02 * m_B[2]) / determinant;
    p[1] = -(c01 * m_B[0] + c11 * m_B[1] + c12 * m_B[2]) / determinant;
    p[2] = -(c02 * m_B[0] + c12 * m_B[1] + c22 * m_B[2]) / determinant;
    return true;
  }

private:
  Eigen::Vector3d
  Multiply(const Eigen::Vector3d & p) const
  {
    return { m_A[0] * p[0] + m_A[1] * p[1] + m_A[2] * p[2],
             m_A[1] * p[0] + m_A[3] * p[1] + m_A[4] * p[2],
             m_A[2] * p[0] + m_A[4] * p[1] + m_A[5] * p[2] };
  }

  double          m_A[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 }; ///< xx, xy, xz, yy, yz, zz
  Eigen::Vector3d m_B{ Eigen::Vector3d::Zero() };
  double          m_C{ 0.0 };
};
} // namespace shapeton

#endif
