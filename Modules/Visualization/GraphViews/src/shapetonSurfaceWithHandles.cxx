#include "shapetonSurfaceWithHandles.h"

#include "shapetonHandleCut.h"
#include "shapetonTubeMesh.h"

#include <algorithm>
#include <numeric>

namespace shapeton
{
namespace
{
/** Maximum size of a hole: as a fraction of its hub's circle, and as an angle (radians). */
constexpr double shareOfHub = 0.6;
constexpr double largestHole = 0.3;

std::vector<int>
AllEdges(const PackedMap & packed)
{
  std::vector<int> edges(packed.graphEdges);
  std::iota(edges.begin(), edges.end(), 0);
  return edges;
}

std::vector<std::array<SphereHole, 2>>
HolesOf(const HandleCut & cut, const SphericalPacking & packing)
{
  const auto holeOf = [&](int hub) -> SphereHole {
    const SphereCircle &        circle = packing.nodes[hub];
    const std::array<double, 3> center = CenterOf(circle);
    return { hub, { center[0], center[1], center[2] }, std::min(shareOfHub * RadiusOf(circle), largestHole) };
  };
  std::vector<std::array<SphereHole, 2>> pairs;
  for (const std::array<int, 2> & hubs : cut.hubs)
  {
    pairs.push_back({ holeOf(hubs[0]), holeOf(hubs[1]) });
  }
  return pairs;
}

/** Path end at a half-edge. */
int
EndAt(const std::vector<std::vector<int>> & paths, int halfEdge)
{
  return halfEdge % 2 == 0 ? paths[halfEdge / 2].front() : paths[halfEdge / 2].back();
}

/** Appends a path, in either direction, to a curve, which may be closed. */
void
Append(const std::vector<int> & path, bool isForward, std::vector<int> & curve)
{
  std::vector<int> directed = path;
  if (!isForward)
  {
    std::reverse(directed.begin(), directed.end());
  }
  curve.insert(curve.end(), directed.begin() + (curve.empty() ? 0 : 1), directed.end());
}

/** Tubes of a sphere with holes, and the curves on them. */
class Tubes
{
public:
  std::vector<Eigen::Vector3d>    vertices;
  std::vector<std::array<int, 3>> triangles;
  std::vector<double>             twists;

  Tubes(const HandleCut & cut, const SphereWithHoles & sphere)
    : vertices(sphere.vertices), triangles(sphere.triangles), m_Cut(cut), m_Sphere(sphere), m_Curves(cut.across.size())
  {
    m_Rims.resize(2 * cut.hubs.size());
    for (std::size_t vertex = 0; vertex < sphere.rims.size(); ++vertex)
    {
      if (sphere.rims[vertex] >= 0)
      {
        m_Rims[sphere.rims[vertex]].push_back(static_cast<int>(vertex));
      }
    }
  }
  void
  Add(std::size_t handle, const HandleTube & tube)
  {
    const std::vector<int>          halfEdges = m_Cut.sphere.Around(m_Cut.hubs[handle][0]);
    std::vector<std::array<int, 2>> ends;
    for (const int h : halfEdges)
    {
      ends.push_back({ EndAt(m_Sphere.paths, h), EndAt(m_Sphere.paths, m_Cut.across[h]) });
    }
    const TubeMesh mesh(tube.Sections(), { m_Rims[2 * handle], m_Rims[2 * handle + 1] }, ends, vertices, triangles);
    for (std::size_t i = 0; i < halfEdges.size(); ++i)
    {
      m_Curves[halfEdges[i]] = mesh.Curves()[i];
    }
    twists.push_back(mesh.Twist());
  }
  /** The whole curve of an edge of the map: its parts on the sphere and through the tubes between them. */
  std::vector<int>
  CurveOf(int edge) const
  {
    std::vector<int> curve;
    for (int h = 2 * edge; h >= 0;)
    {
      Append(m_Sphere.paths[h / 2], h % 2 == 0, curve);
      const int end = CombinatorialMap::Twin(h);
      h = m_Cut.across[end];
      if (h >= 0)
      {
        const bool isForward = !m_Curves[end].empty();
        Append(m_Curves[isForward ? end : h], isForward, curve);
      }
    }
    return curve;
  }

private:
  const HandleCut &             m_Cut;
  const SphereWithHoles &       m_Sphere;
  std::vector<std::vector<int>> m_Rims;   ///< vertices on the rim of each hole
  std::vector<std::vector<int>> m_Curves; ///< for half-edges at a first hub, from the first hub to the second
};
} // namespace

SurfaceWithHandles::SurfaceWithHandles(const CombinatorialMap & map, double longest)
{
  const HandleCut        cut(map);
  const PackedMap        packed = MakePackedMap(cut.sphere);
  const SphericalPacking packing = PackOnSphere(packed.map, PointAtInfinity::Circle, AllEdges(packed));
  const std::vector<std::array<SphereHole, 2>> pairs = HolesOf(cut, packing);
  const std::vector<HandleTube>                handles = PlaceTubes(pairs);
  std::vector<SphereHole>                      holes;
  for (const std::array<SphereHole, 2> & pair : pairs)
  {
    holes.insert(holes.end(), pair.begin(), pair.end());
  }
  const SphereWithHoles sphere = TriangulateSphere(packed, packing, holes, longest);
  Tubes                 tubes(cut, sphere);
  for (std::size_t handle = 0; handle < handles.size(); ++handle)
  {
    tubes.Add(handle, handles[handle]);
  }
  for (const Eigen::Vector3d & vertex : tubes.vertices)
  {
    m_Vertices.push_back({ vertex[0], vertex[1], vertex[2] });
  }
  m_Triangles = std::move(tubes.triangles);
  m_Twists = std::move(tubes.twists);
  for (int edge = 0; edge < map.Edges(); ++edge)
  {
    m_Edges.push_back(tubes.CurveOf(edge));
  }
}
} // namespace shapeton
