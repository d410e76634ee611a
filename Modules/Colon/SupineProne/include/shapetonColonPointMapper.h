#ifndef shapetonColonPointMapper_h
#define shapetonColonPointMapper_h

#include "shapetonFlatColonLocator.h"
#include "shapetonSupineProneRegistration.h"

namespace shapeton
{
/** A place of the wall mapped by the registration. \ingroup ShapetonSupineProne */
struct MappedPoint
{
  /** Place on the flat map of the other position, mm; v in [0, circumference). */
  Eigen::Vector2d uv{ Eigen::Vector2d::Zero() };
  /** The place on the wall in space, LPS, mm. */
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  /** Local confidence of the registration, 0 to 1. */
  double confidence{ 0.0 };
  /** Whether the wall is not visible there in one of the positions: the map is interpolated from both sides. */
  bool isExcluded{ true };
  /** Distance of the input point from its own wall, mm; 0 for a place on the map. */
  double distance{ 0.0 };
};

/** \class ColonPointMapper
 * \brief Maps points in space and places on the map from one position to the other, in both directions.
 *
 * For findings of one position: points, polyps, vertex labels. The registration must outlive the object. Thread-safe.
 * Uv and point are NaN where the map misses the place, which a registration without flips (RegistrationFigures::flips)
 * never does, or where the wall has a hole.
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
  /** Maps places on the map. */
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
