#ifndef shapetonColonPointMapper_h
#define shapetonColonPointMapper_h

#include "shapetonFlatColonLocator.h"
#include "shapetonSupineProneRegistration.h"

namespace shapeton
{
/** A point of the wall mapped by the registration. \ingroup ShapetonSupineProne */
struct MappedPoint
{
  /** Position on the flat map of the other position, mm; v in [0, circumference). */
  Eigen::Vector2d uv{ Eigen::Vector2d::Zero() };
  /** Point on the wall of the other position, LPS, mm. */
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  /** Local confidence: the probability that the point is within ConfidentDistance of the true one. */
  double confidence{ 0.0 };
  /** Whether the wall is not visible in one of the positions, so that the map is interpolated from both sides. */
  bool isExcluded{ true };
  /** Distance (mm) from the input point to its wall; 0 for map positions. */
  double distance{ 0.0 };
};

/** \class ColonPointMapper
 * \brief Maps points in space and on the flat map between the two positions.
 *
 * Intended for findings in one position: points, polyps, vertex labels. The registration must outlive the object.
 * Thread-safe. Uv and point are NaN at holes of the wall, and where the inverse map is undefined, which occurs only if
 * RegistrationFigures::flips is nonzero.
 * \ingroup ShapetonSupineProne */
class ShapetonSupineProne_EXPORT ColonPointMapper
{
public:
  explicit ColonPointMapper(const SupineProneRegistration & registration);

  /** Maps the nearest point of the wall from source to target. */
  MappedPoint
  Forward(const Eigen::Vector3d & point) const;
  MappedPoint
  Inverse(const Eigen::Vector3d & point) const;
  /** Maps flat map positions. */
  MappedPoint
  ForwardUv(const Eigen::Vector2d & sourceUv) const;
  MappedPoint
  InverseUv(const Eigen::Vector2d & targetUv) const;

private:
  const SupineProneRegistration & m_Registration;
  FlatColonLocator                m_Source;
  FlatColonLocator                m_Target;
};
} // namespace shapeton

#endif
