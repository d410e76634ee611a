#ifndef shapetonColonPointMapper_h
#define shapetonColonPointMapper_h

#include "shapetonFlatColonLocator.h"
#include "shapetonSupineProneRegistration.h"

namespace shapeton
{
/** Where the registration takes a place of the wall. \ingroup SupineProne */
struct MappedPoint
{
  /** Place on the flat map of the other position, mm; v in [0, circumference). */
  Eigen::Vector2d uv{ Eigen::Vector2d::Zero() };
  /** The same on the wall in space, LPS, mm. */
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  /** 0 to 1, of the registration there. */
  double confidence{ 0.0 };
  /** Nothing is to be seen there in one of the positions: the map is carried on from both sides. */
  bool isExcluded{ true };
  /** Of the point asked for from its own wall, mm; 0 for a place on the map. */
  double distance{ 0.0 };
};

/** \class ColonPointMapper
 * \brief Takes points in space and places on the map from one position to the other, both ways.
 *
 * For what was found in one position: points, polyps, labels vertex by vertex. The registration must outlive the
 * object, which may be asked by many threads at once. Uv and point are not numbers where the map misses the place,
 * which a registration without flips (RegistrationFigures::flips) never does, or where the wall has a hole.
 * \ingroup SupineProne */
class SupineProne_EXPORT ColonPointMapper
{
public:
  explicit ColonPointMapper(const SupineProneRegistration & registration);

  /** From source to target, of the nearest point of the wall. */
  MappedPoint
  Forward(const Eigen::Vector3d & point) const;
  MappedPoint
  Inverse(const Eigen::Vector3d & point) const;
  /** The same of places on the map. */
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
