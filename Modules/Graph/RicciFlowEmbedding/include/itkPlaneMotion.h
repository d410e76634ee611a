#ifndef itkPlaneMotion_h
#define itkPlaneMotion_h

#include "itkCirclePacking.h"

#include <cmath>
#include <complex>

namespace itk
{
/** \brief A motion that keeps orientation: `z -> (a z + b) / (conj(b) z + conj(a))`, |a|^2 - |b|^2 = 1, of the Poincare
 * disk, or `z -> a z + b`, |a| = 1, of the plane. Motions of the disk are the same for (a, b) and (-a, -b).
 * \ingroup RicciFlowEmbedding */
struct PlaneMotion
{
  using Complex = std::complex<double>;

  /** Around the origin. Radians. */
  static PlaneMotion
  Rotation(FlowGeometry geometry, double angle)
  {
    return { geometry, std::polar(1.0, geometry == FlowGeometry::Euclidean ? angle : 0.5 * angle), 0.0 };
  }
  /** Of the origin along the real axis. */
  static PlaneMotion
  Translation(FlowGeometry geometry, double length)
  {
    return geometry == FlowGeometry::Euclidean
             ? PlaneMotion{ geometry, 1.0, length }
             : PlaneMotion{ geometry, std::cosh(0.5 * length), std::sinh(0.5 * length) };
  }
  /** First `other`, then this one. */
  PlaneMotion
  operator*(const PlaneMotion & other) const
  {
    if (geometry == FlowGeometry::Euclidean)
    {
      return { geometry, a * other.a, a * other.b + b };
    }
    return { geometry, a * other.a + b * std::conj(other.b), a * other.b + b * std::conj(other.a) };
  }
  PlaneMotion
  Inverse() const
  {
    return geometry == FlowGeometry::Euclidean ? PlaneMotion{ geometry, std::conj(a), -std::conj(a) * b }
                                               : PlaneMotion{ geometry, std::conj(a), -b };
  }
  Complex
  operator()(const Complex & z) const
  {
    return geometry == FlowGeometry::Euclidean ? a * z + b : (a * z + b) / (std::conj(b) * z + std::conj(a));
  }
  /** The direction of the real axis at the image of the origin. Radians. */
  double
  Direction() const
  {
    return geometry == FlowGeometry::Euclidean ? std::arg(a) : std::remainder(2.0 * std::arg(a), 2.0 * std::acos(-1.0));
  }
  /** Takes rounding errors of many products out of |a|; |a|^2 - |b|^2 itself would cancel far from the origin. */
  PlaneMotion
  Normalised() const
  {
    const double length = geometry == FlowGeometry::Euclidean ? 1.0 : std::sqrt(1.0 + std::norm(b));
    return { geometry, a * (length / std::abs(a)), b };
  }

  FlowGeometry geometry{ FlowGeometry::Euclidean };
  Complex      a{ 1.0 };
  Complex      b{ 0.0 };
};
} // namespace itk

#endif
