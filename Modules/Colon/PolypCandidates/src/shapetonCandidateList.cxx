#include "shapetonCandidateList.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>

namespace shapeton
{
namespace
{
constexpr double rimWidth = 3.0; // mm

/** Width (mm) of a head that is hidden by the fillet at its foot, as measured on phantoms (see the README). Heads lower
 * than about half their width merge into the wall before their maximum width. */
double
HiddenRim(double prominence)
{
  constexpr double rim = 0.9, low = 0.45, high = 0.65; // mm; height per width
  return rim * std::clamp((high - prominence) / (high - low), 0.0, 1.0);
}

double
ArcLengthOf(const std::vector<int> & vertices, const SurfaceMesh & wall)
{
  const SurfaceArray * const arcLength = FindSurfaceArray(wall.pointArrays, "arcLength");
  if (arcLength == nullptr)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  double sum = 0.0;
  for (const int vertex : vertices)
  {
    sum += arcLength->values(vertex, 0);
  }
  return sum / static_cast<double>(vertices.size());
}

bool
IsSameHead(const PolypCandidate & a, const PolypCandidate & b)
{
  if ((a.position - b.position).norm() < 0.5 * std::max(a.diameter, b.diameter))
  {
    return true;
  }
  std::vector<int> shared;
  std::set_intersection(
    a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(), std::back_inserter(shared));
  return 10 * shared.size() > std::min(a.vertices.size(), b.vertices.size());
}
} // namespace

std::vector<char>
FindNoWall(const SurfaceMesh & wall, const SurfaceConnectivity & connectivity)
{
  std::vector<char>          isLeftOut(wall.NumberOfVertices(), 0);
  const SurfaceArray * const bridged = FindSurfaceArray(wall.cellArrays, "bridged");
  for (int face = 0; bridged != nullptr && face < wall.NumberOfFaces(); ++face)
  {
    for (int k = 0; k < 3; ++k)
    {
      isLeftOut[wall.F(face, k)] |= bridged->values(face, 0) != 0.0;
    }
  }
  // Straight distances are sufficient, since rims are smooth and far from other parts of the wall.
  std::vector<int>    reached;
  std::vector<double> way(wall.NumberOfVertices(), std::numeric_limits<double>::infinity());
  for (const std::vector<int> & loop : connectivity.BoundaryLoops())
  {
    for (const int vertex : loop)
    {
      way[vertex] = 0.0;
      reached.push_back(vertex);
    }
  }
  for (std::size_t next = 0; next < reached.size(); ++next)
  {
    isLeftOut[reached[next]] = 1;
    for (const int neighbor : connectivity.NeighborsOfVertex(reached[next]))
    {
      const double whole = way[reached[next]] + (wall.V.row(neighbor) - wall.V.row(reached[next])).norm();
      if (whole < std::min(rimWidth, way[neighbor]))
      {
        way[neighbor] = whole;
        reached.push_back(neighbor);
      }
    }
  }
  return isLeftOut;
}

PolypCandidate
CandidateOf(WallBulge bulge, const PolypFeatures & features, double score, const SurfaceMesh & wall)
{
  PolypCandidate candidate;
  candidate.score = score;
  candidate.shapeScore = score;
  candidate.position = bulge.center;
  candidate.apex = bulge.apex;
  candidate.axis = bulge.axis;
  const double hidden = HiddenRim(features.prominence);
  candidate.diameter = bulge.greatestWidth + hidden;
  candidate.leastDiameter = bulge.leastWidth + hidden;
  candidate.height = bulge.height;
  candidate.features = features;
  candidate.arcLength = ArcLengthOf(bulge.vertices, wall);
  candidate.vertices = std::move(bulge.vertices);
  return candidate;
}

void
AddRemark(const std::string & remark, PolypCandidate & candidate)
{
  candidate.remark += (candidate.remark.empty() || remark.empty() ? "" : "; ") + remark;
}

void
SortByScore(std::vector<PolypCandidate> & candidates)
{
  std::stable_sort(candidates.begin(), candidates.end(), [](const PolypCandidate & a, const PolypCandidate & b) {
    return a.score > b.score;
  });
}

void
Rank(std::vector<PolypCandidate> & candidates)
{
  SortByScore(candidates);
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    candidates[i].number = static_cast<int>(i) + 1;
  }
}

void
SortAndNumber(std::vector<PolypCandidate> & candidates)
{
  Rank(candidates);
  std::vector<PolypCandidate> kept;
  for (PolypCandidate & candidate : candidates)
  {
    if (std::none_of(
          kept.begin(), kept.end(), [&](const PolypCandidate & better) { return IsSameHead(better, candidate); }))
    {
      candidate.number = static_cast<int>(kept.size()) + 1;
      kept.push_back(std::move(candidate));
    }
  }
  candidates = std::move(kept);
}

std::vector<Eigen::Vector3d>
PointsBelowSurface(const SurfaceMesh & wall, const PolypCandidate & candidate)
{
  const double    depth = std::clamp(candidate.leastDiameter / 3.0, 1.0, 4.0);
  Eigen::Vector3d inside = Eigen::Vector3d::Zero(); // approximate center of the head
  for (const int vertex : candidate.vertices)
  {
    inside += wall.V.row(vertex).transpose() / static_cast<double>(candidate.vertices.size());
  }
  inside -= depth * candidate.axis;
  std::vector<Eigen::Vector3d> points;
  for (const int vertex : candidate.vertices)
  {
    const Eigen::Vector3d point = wall.V.row(vertex).transpose();
    const Eigen::Vector3d way = inside - point;
    points.push_back(point + way * std::min(1.0, depth / std::max(way.norm(), 1e-9)));
  }
  return points;
}
} // namespace shapeton
