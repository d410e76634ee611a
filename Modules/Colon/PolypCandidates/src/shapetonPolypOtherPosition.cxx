#include "shapetonPolypSearch.h"

#include "shapetonFacePlace.h"
#include "shapetonSurfaceLocator.h"
#include "shapetonExceptions.h"

namespace shapeton
{
namespace
{
constexpr double farthestFromMap = 10.0; // mm

const SurfaceArray &
ArrayOf(const SurfaceMesh & map, const char * name, int components, const std::string & what)
{
  const SurfaceArray * const array = FindSurfaceArray(map.pointArrays, name);
  if (array == nullptr || array->values.cols() != components)
  {
    throw InputError(what + ": no point array " + name + "; give a folder that ColonRegistration has written");
  }
  return *array;
}

void
FindNearest(const std::vector<Eigen::Vector3d> & others, double reach, PolypInOtherPosition & place)
{
  for (std::size_t i = 0; i < others.size(); ++i)
  {
    const double distance = (others[i] - place.point).norm();
    if (distance < place.distance)
    {
      place.distance = distance;
      place.candidate = static_cast<int>(i) + 1;
    }
  }
  place.isSeen = !place.isExcluded && place.distance <= reach;
}
} // namespace

double
MeanDistanceToWall(const SurfaceMesh & wall, const std::vector<PolypCandidate> & candidates)
{
  if (candidates.empty())
  {
    return 0.0;
  }
  const SurfaceLocator locator(wall.V, wall.F);
  double               sum = 0.0;
  for (const PolypCandidate & candidate : candidates)
  {
    sum += locator.FindClosest(candidate.position).distance;
  }
  return sum / static_cast<double>(candidates.size());
}

void
FindInOtherPosition(const SurfaceMesh &                  map,
                    const std::string &                  what,
                    const std::vector<Eigen::Vector3d> & others,
                    std::vector<PolypCandidate> &        candidates,
                    double                               reach)
{
  const SurfaceArray & mapped = ArrayOf(map, "mapped", 3, what);
  const SurfaceArray & confidence = ArrayOf(map, "confidence", 1, what);
  const SurfaceArray & excluded = ArrayOf(map, "excluded", 1, what);
  if (MeanDistanceToWall(map, candidates) > farthestFromMap)
  {
    throw InputError(what + ": candidates lie more than 10 mm from the wall that was registered; give the "
                            "registration of this colon");
  }
  const SurfaceLocator locator(map.V, map.F);
  for (PolypCandidate & candidate : candidates)
  {
    const SurfaceLocator::Closest closest = locator.FindClosest(candidate.position);
    const Eigen::Vector3d         weights = BarycentricOf(map, closest.face, closest.point);
    PolypInOtherPosition          place;
    for (int k = 0; k < 3; ++k)
    {
      const int vertex = map.F(closest.face, k);
      place.point += weights[k] * mapped.values.row(vertex).transpose();
      place.confidence += weights[k] * confidence.values(vertex, 0);
      place.isExcluded = place.isExcluded || excluded.values(vertex, 0) != 0.0;
    }
    FindNearest(others, reach, place);
    candidate.other = place;
  }
}
} // namespace shapeton
