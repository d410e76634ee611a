#include "shapetonPi.h"
#include "shapetonPolypMorphology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>

namespace shapeton
{
namespace
{
constexpr double girthFrom = 2.0, girthTo = 4.0; // mm beyond the edge of a head; chosen
constexpr double ringAtFold = 2.0;               // mm; chosen

/** Distances (mm) along edges from a head to the vertices around it, excluding its own vertices. */
std::map<int, double>
VerticesAround(const SurfaceMesh &         wall,
               const SurfaceConnectivity & connectivity,
               const std::vector<int> &    head,
               double                      reach)
{
  using Arrival = std::pair<double, int>;
  std::map<int, double>                                                     distances;
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<Arrival>> queue;
  for (const int vertex : head)
  {
    distances[vertex] = 0.0;
    queue.push({ 0.0, vertex });
  }
  while (!queue.empty())
  {
    const auto [distance, vertex] = queue.top();
    queue.pop();
    if (distance > distances.at(vertex))
    {
      continue;
    }
    for (const int neighbor : connectivity.NeighborsOfVertex(vertex))
    {
      const double whole = distance + (wall.V.row(neighbor) - wall.V.row(vertex)).norm();
      const auto   found = distances.find(neighbor);
      if (whole <= reach && (found == distances.end() || whole < found->second))
      {
        distances[neighbor] = whole;
        queue.push({ whole, neighbor });
      }
    }
  }
  for (const int vertex : head)
  {
    distances.erase(vertex);
  }
  return distances;
}

/** Mean girth (mm) of the surface between two distances: the area of the band divided by its width. */
double
GirthOf(const SurfaceMesh & wall, const SurfaceConnectivity & connectivity, const std::map<int, double> & around)
{
  double area = 0.0;
  for (const auto & [vertex, distance] : around)
  {
    if (distance < girthFrom || distance > girthTo)
    {
      continue;
    }
    for (const int face : connectivity.FacesOfVertex(vertex))
    {
      const Eigen::Vector3d a = wall.V.row(wall.F(face, 0)), b = wall.V.row(wall.F(face, 1)),
                            c = wall.V.row(wall.F(face, 2));
      area += (b - a).cross(c - a).norm() / 6.0; // a third of the area
    }
  }
  return area / (girthTo - girthFrom);
}

PolypMorphology
MorphologyOf(const PolypCandidate & candidate, double girth)
{
  constexpr double highestFlat = 3.0; // mm; C-RADS, Paris classification
  constexpr double flatness = 0.5;    // height by width; Paris classification
  constexpr double narrowest = 0.8;   // girth of a stalk by girth of its head
  const double     girthOfHead = Pi * candidate.leastDiameter;
  if (candidate.height <= highestFlat && candidate.height < flatness * candidate.leastDiameter)
  {
    return PolypMorphology::Flat;
  }
  return girth < narrowest * girthOfHead ? PolypMorphology::Pedunculated : PolypMorphology::Sessile;
}

bool
IsOnFold(const SurfaceMesh &                                  wall,
         const std::function<bool(const Eigen::Vector3d &)> & isFold,
         const std::map<int, double> &                        around)
{
  int ring = 0, onFold = 0;
  for (const auto & [vertex, distance] : around)
  {
    if (distance <= ringAtFold)
    {
      ++ring;
      onFold += isFold(wall.V.row(vertex).transpose()) ? 1 : 0;
    }
  }
  return 2 * onFold > ring;
}

/** Greatest distance (mm) between points of a head that are near the plane through its center perpendicular to an
 * axis. */
double
DiameterInPlane(const SurfaceMesh & wall, const PolypCandidate & candidate, int axis)
{
  constexpr double             halfThickness = 0.75; // mm, half a usual slice
  std::vector<Eigen::Vector3d> cut;
  for (const int vertex : candidate.vertices)
  {
    const Eigen::Vector3d point = wall.V.row(vertex).transpose();
    if (std::abs(point[axis] - candidate.position[axis]) <= halfThickness)
    {
      cut.push_back(point);
    }
  }
  double greatest = 0.0;
  for (std::size_t i = 0; i < cut.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      Eigen::Vector3d way = cut[i] - cut[j];
      way[axis] = 0.0;
      greatest = std::max(greatest, way.norm());
    }
  }
  return greatest;
}

void
MeasureInPlanes(const SurfaceMesh & wall, PolypCandidate & candidate)
{
  const char * const planes[] = { "sagittal", "coronal", "axial" };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double diameter = DiameterInPlane(wall, candidate, axis);
    if (!(diameter <= candidate.planeDiameter))
    {
      candidate.planeDiameter = diameter;
      candidate.plane = planes[axis];
    }
  }
}

bool
AreNear(const SurfaceMesh & wall, const PolypCandidate & a, const PolypCandidate & b)
{
  // mm: the heads of clumps of stool in a phantom and the lips of valves are 2.3 to 3.3 mm apart, polyps farther.
  constexpr double nearest = 4.0;
  return std::any_of(a.vertices.begin(), a.vertices.end(), [&](int i) {
    return std::any_of(b.vertices.begin(), b.vertices.end(), [&](int j) {
      return (wall.V.row(i) - wall.V.row(j)).squaredNorm() <= nearest * nearest;
    });
  });
}
} // namespace

void
MeasureMorphology(const SurfaceMesh &                                  wall,
                  const std::function<bool(const Eigen::Vector3d &)> & isFold,
                  std::vector<PolypCandidate> &                        candidates)
{
  const SurfaceConnectivity connectivity(wall);
  for (PolypCandidate & candidate : candidates)
  {
    const std::map<int, double> around = VerticesAround(wall, connectivity, candidate.vertices, girthTo);
    candidate.morphology = MorphologyOf(candidate, GirthOf(wall, connectivity, around));
    candidate.isOnFold = isFold && IsOnFold(wall, isFold, around);
    MeasureInPlanes(wall, candidate);
  }
}

void
JoinFragments(const SurfaceMesh & wall, std::vector<PolypCandidate> & candidates)
{
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    candidates[i].mainCandidate = candidates[i].number;
    for (std::size_t j = 0; j < i; ++j)
    {
      const bool mayHidePolyp =
        candidates[i].lookalike == PolypLookalike::None && candidates[j].lookalike != PolypLookalike::None;
      if (!mayHidePolyp && AreNear(wall, candidates[i], candidates[j]))
      {
        candidates[i].mainCandidate = candidates[j].mainCandidate;
        break;
      }
    }
  }
}

std::string
MorphologyInWords(const PolypCandidate & candidate)
{
  const double      largest = std::max(candidate.diameter, candidate.planeDiameter); // the former if the latter is NaN
  const bool        isDiminutive = SizeOf(largest) == PolypSize::Below6;
  const std::string name =
    candidate.morphology != PolypMorphology::Unknown && isDiminutive ? "diminutive" : NameOf(candidate.morphology);
  return name.empty() || !candidate.isOnFold ? name : name + ", on a fold";
}
} // namespace shapeton
