#ifndef shapetonPlaneMotion_h
#define shapetonPlaneMotion_h

#include "shapetonCirclePacking.h"

#include <cmath>
#include <complex>

namespace shapeton
{
/** \brief An orientation-preserving motion: `z -> (a z + b) / (conj(b) z + conj(a))`, |a|^2 - |b|^2 = 1, of the
 * Poincare disk, or `z -> a z + b`, |a| = 1, of the plane. In the disk (a, b) and (-a, -b) are the same motion.
 * \ingroup ShapetonRicciFlowEmbedding */
template <typename TReal>
struct BasicPlaneMotion
{
  using Complex = std::complex<TReal>;

  /** Rotation around the origin (radians). */
  static BasicPlaneMotion
  Rotation(FlowGeometry geometry, TReal angle)
  {
    return { geometry, std::polar(TReal(1), geometry == FlowGeometry::Euclidean ? angle : TReal(0.5) * angle), 0.0 };
  }
  /** Translation of the origin along the real axis. */
  static BasicPlaneMotion
  Translation(FlowGeometry geometry, TReal length)
  {
    return geometry == FlowGeometry::Euclidean
             ? BasicPlaneMotion{ geometry, TReal(1), length }
             : BasicPlaneMotion{ geometry, std::cosh(TReal(0.5) * length), std::sinh(TReal(0.5) * length) };
  }
  /** Composition: first `other`, then this one. */
  BasicPlaneMotion
  operator*(const BasicPlaneMotion & other) const
  {
    if (geometry == FlowGeometry::Euclidean)
    {
      return { geometry, a * other.a, a * other.b + b };
    }
    return { geometry, a * other.a + b * std::conj(other.b), a * other.b + b * std::conj(other.a) };
  }
  BasicPlaneMotion
  Inverse() const
  {
    return geometry == FlowGeometry::Euclidean ? BasicPlaneMotion{ geometry, std::conj(a), -std::conj(a) * b }
                                               : BasicPlaneMotion{ geometry, std::conj(a), -b };
  }
  Complex
  operator()(const Complex & z) const
  {
    return geometry == FlowGeometry::Euclidean ? a * z + b : (a * z + b) / (std::conj(b) * z + std::conj(a));
  }
  /** Direction of the real axis at the image of the origin (radians). */
  TReal
  Direction() const
  {
    return geometry == FlowGeometry::Euclidean
             ? std::arg(a)
             : std::remainder(TReal(2) * std::arg(a), TReal(2) * std::acos(TReal(-1)));
  }
  /** Removes accumulated rounding errors from |a|; |a|^2 - |b|^2 itself would cancel far from the origin. */
  BasicPlaneMotion
  Normalized() const
  {
    const TReal length = geometry == FlowGeometry::Euclidean ? TReal(1) : std::sqrt(TReal(1) + std::norm(b));
    return { geometry, a * (length / std::abs(a)), b };
  }

  FlowGeometry geometry{ FlowGeometry::Euclidean };
  Complex      a{ 1 };
  Complex      b{ 0 };
};

using PlaneMotion = BasicPlaneMotion<double>;
} // namespace shapeton

#endif
