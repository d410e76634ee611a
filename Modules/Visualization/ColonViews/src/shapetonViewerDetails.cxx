#include "shapetonViewerDetails.h"

#include "shapetonParallelFor.h"
#include "shapetonSurfaceLocator.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>

namespace shapeton
{
namespace
{
using Eigen::Vector3d;

constexpr double overlap = 1.0; // mm
/** Reach (mm) around the center of a head: covers a 30 mm polyp, or a smaller one and the wall around it. */
constexpr double leastReach = 15.0, timesDiameter = 0.75;
/** Reach (mm) around the cap of a pouch, and least distance (mm) from the flat wall, which deviates by less than 1 mm
 * elsewhere. */
constexpr double reachOfCap = 3.0, leastDeparture = 1.5;

/** The faces of the flat wall that close pouches; null if there are none. */
std::unique_ptr<SurfaceLocator>
CapsOf(const SurfaceMesh & flat)
{
  const SurfaceArray * const cap = FindSurfaceArray(flat.cellArrays, "cap");
  std::vector<int>           faces;
  for (int face = 0; cap != nullptr && face < flat.NumberOfFaces(); ++face)
  {
    if (cap->values(face, 0) != 0.0)
    {
      faces.push_back(face);
    }
  }
  if (faces.empty())
  {
    return nullptr;
  }
  const SurfaceMesh caps = FacesOfSurface(flat, faces);
  return std::make_unique<SurfaceLocator>(caps.V, caps.F);
}

/** The places shown at full resolution. */
class DetailRegion
{
public:
  DetailRegion(const SurfaceMesh & flat, const Json & candidates) : m_Caps(CapsOf(flat))
  {
    for (const Json & one : candidates)
    {
      m_Heads.emplace_back(Vector3d(one.at("x"), one.at("y"), one.at("z")),
                           std::max(leastReach, timesDiameter * one.at("diameter").get<double>()));
    }
  }

  /** Signed distance (mm), negative inside. */
  double
  DistanceOf(const Vector3d & point) const
  {
    double distance = m_Caps ? m_Caps->FindClosest(point).distance - reachOfCap : std::numeric_limits<double>::max();
    for (const auto & [center, reach] : m_Heads)
    {
      distance = std::min(distance, (point - center).norm() - reach);
    }
    return distance;
  }

private:
  std::unique_ptr<SurfaceLocator>          m_Caps;
  std::vector<std::pair<Vector3d, double>> m_Heads;
};

/** Marks the vertices for which a condition holds. */
template <typename TCondition>
std::vector<std::uint8_t>
MarksOf(const VertexMatrix & points, const TCondition & condition)
{
  std::vector<std::uint8_t> marks(points.rows());
  ParallelForBlocks(marks.size(), [&](std::size_t i) {
    marks[i] = condition(Vector3d(points.row(static_cast<Eigen::Index>(i)))) ? 1 : 0;
  });
  return marks;
}

SurfaceMesh
FacesWithMarks(const SurfaceMesh & wall, const std::vector<std::uint8_t> & marks)
{
  std::vector<int> faces;
  for (int face = 0; face < wall.NumberOfFaces(); ++face)
  {
    if (marks[wall.F(face, 0)] != 0 || marks[wall.F(face, 1)] != 0 || marks[wall.F(face, 2)] != 0)
    {
      faces.push_back(face);
    }
  }
  return FacesOfSurface(wall, faces);
}
} // namespace

void
PutViewerDetails(PageBlocks &        blocks,
                 const std::string & prefix,
                 const SurfaceMesh & flat,
                 const SurfaceMesh & wall,
                 const Json &        candidates)
{
  const DetailRegion   region(flat, candidates);
  const SurfaceLocator onFlat(flat.V, flat.F);
  const SurfaceMesh    details =
    FacesWithMarks(wall, MarksOf(wall.V, [&](const Vector3d & point) {
                     return region.DistanceOf(point) < 0.0 || onFlat.FindClosest(point).distance > leastDeparture;
                   }));
  std::vector<std::uint32_t> corners;
  for (Eigen::Index face = 0; face < details.F.rows(); ++face)
  {
    for (int k = 0; k < 3; ++k)
    {
      corners.push_back(static_cast<std::uint32_t>(details.F(face, k)));
    }
  }
  blocks.PutReals(prefix + "detailPoints", details.V);
  blocks.Put(prefix + "detailFaces", corners, 3);
  blocks.Put(prefix + "replaced",
             MarksOf(flat.V, [&](const Vector3d & point) { return region.DistanceOf(point) < -overlap; }));
}
} // namespace shapeton
