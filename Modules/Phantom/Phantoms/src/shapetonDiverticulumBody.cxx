#include "shapetonDiverticulumBody.h"

#include <algorithm>

namespace shapeton
{
namespace
{
constexpr double c_Shoulder = 0.6; // mm
}

ColonDistance
DiverticulumBody::Distance(const Eigen::Vector3d & point) const
{
  return JoinTissue(CapsuleDistance(point, mouth, sac, neckRadius), SphereDistance(point, sac, radius), c_Shoulder);
}

double
DiverticulumBody::Extent() const
{
  return std::max(radius, (sac - mouth).norm() + neckRadius) + c_Shoulder;
}

DiverticulumBody
BodyOf(const ColonDiverticulum & diverticulum)
{
  return { diverticulum.mouth, diverticulum.position, 0.5 * diverticulum.neck, 0.5 * diverticulum.diameter, 0.0, 0.0,
           diverticulum.id - 1 };
}
} // namespace shapeton
