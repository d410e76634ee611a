#include "shapetonColonPointMapper.h"

#include <limits>

namespace shapeton
{
ColonPointMapper::ColonPointMapper(const SupineProneRegistration & registration)
  : m_Registration(registration), m_Source(registration.sourceFlat->Grid()), m_Target(registration.targetFlat->Grid())
{}

MappedPoint
ColonPointMapper::ForwardUv(const Eigen::Vector2d & sourceUv) const
{
  const CylinderPlace from = m_Registration.source->PlaceOfUv(sourceUv);
  const CylinderPlace to = m_Registration.map.Forward(from);
  return { m_Registration.target->UvOfPlace(to),
           m_Registration.target->PointOfPlace(to),
           ConfidenceAt(m_Registration, from),
           IsExcludedAt(m_Registration, from),
           0.0 };
}

MappedPoint
ColonPointMapper::InverseUv(const Eigen::Vector2d & targetUv) const
{
  const std::optional<CylinderPlace> to = m_Registration.map.Inverse(m_Registration.target->PlaceOfUv(targetUv));
  if (!to)
  {
    MappedPoint nowhere;
    nowhere.uv.setConstant(std::numeric_limits<double>::quiet_NaN());
    nowhere.point.setConstant(std::numeric_limits<double>::quiet_NaN());
    return nowhere;
  }
  return { m_Registration.source->UvOfPlace(*to),
           m_Registration.source->PointOfPlace(*to),
           ConfidenceAt(m_Registration, *to),
           IsExcludedAt(m_Registration, *to),
           0.0 };
}

MappedPoint
ColonPointMapper::Forward(const Eigen::Vector3d & point) const
{
  const FlatPlace place = m_Source.Find(point);
  MappedPoint     mapped = this->ForwardUv(place.uv);
  mapped.distance = place.distance;
  return mapped;
}

MappedPoint
ColonPointMapper::Inverse(const Eigen::Vector3d & point) const
{
  const FlatPlace place = m_Target.Find(point);
  MappedPoint     mapped = this->InverseUv(place.uv);
  mapped.distance = place.distance;
  return mapped;
}
} // namespace shapeton
