#include "GeneratedSurfaces.h"

#include "shapetonBoundaryLoops.h"
#include "shapetonColonWall.h"
#include "shapetonSurfaceCut.h"
#include "shapetonSurfaceRemeshing.h"
#include "shapetonSurfaceRepair.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

using namespace shapeton;
using Eigen::Vector3d;

namespace
{
SignedDistance
Ellipsoid(const Vector3d & center, const Vector3d & radii)
{
  // Not an exact distance, but its gradient is about 1 near the surface.
  return [=](const Vector3d & p) {
    const Vector3d q = (p - center).cwiseQuotient(radii);
    const double   slope = q.cwiseQuotient(radii).norm();
    return slope > 0.0 ? q.norm() * (q.norm() - 1.0) / slope : -radii.minCoeff();
  };
}

SurfaceMesh
LargestComponent(const SurfaceMesh & mesh)
{
  const SurfaceConnectivity connectivity(mesh);
  const auto &              components = connectivity.Components();
  const auto                largest = std::max_element(
    components.begin(), components.end(), [](const auto & a, const auto & b) { return a.faces < b.faces; });
  std::vector<int> faces;
  for (int face = 0; face < mesh.NumberOfFaces(); ++face)
  {
    if (connectivity.ComponentOfFaces()[face] == static_cast<int>(largest - components.begin()))
    {
      faces.push_back(face);
    }
  }
  return FacesOfSurface(mesh, faces);
}

/** Cuts faces along the zero set of a function of position. */
class Clipper
{
public:
  Clipper(const SurfaceMesh & mesh, const std::function<double(const Vector3d &)> & inside) : m_Mesh(mesh)
  {
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v)
    {
      m_Points.emplace_back(mesh.V.row(v));
      m_Values.push_back(inside(m_Points.back()));
    }
  }
  /** Part of the surface where the function is positive. */
  SurfaceMesh
  Positive()
  {
    std::vector<Eigen::RowVector3i> faces;
    for (Eigen::Index face = 0; face < m_Mesh.F.rows(); ++face)
    {
      std::vector<int> polygon;
      for (int k = 0; k < 3; ++k)
      {
        const int here = m_Mesh.F(face, k);
        const int next = m_Mesh.F(face, (k + 1) % 3);
        if (m_Values[here] > 0.0)
        {
          polygon.push_back(here);
        }
        if ((m_Values[here] > 0.0) != (m_Values[next] > 0.0))
        {
          polygon.push_back(this->Crossing(std::min(here, next), std::max(here, next)));
        }
      }
      for (std::size_t k = 2; k < polygon.size(); ++k)
      {
        faces.emplace_back(polygon[0], polygon[k - 1], polygon[k]);
      }
    }
    SurfaceMesh part;
    part.V.resize(static_cast<Eigen::Index>(m_Points.size()), 3);
    part.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t i = 0; i < m_Points.size(); ++i)
    {
      part.V.row(static_cast<Eigen::Index>(i)) = m_Points[i];
    }
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      part.F.row(static_cast<Eigen::Index>(i)) = faces[i];
    }
    return part;
  }

private:
  int
  Crossing(int a, int b)
  {
    const auto [place, isNew] = m_Crossings.emplace(std::make_pair(a, b), static_cast<int>(m_Points.size()));
    if (isNew)
    {
      const double share = std::clamp(m_Values[a] / (m_Values[a] - m_Values[b]), 0.02, 0.98); // avoids degenerate faces
      m_Points.emplace_back(m_Points[a] + share * (m_Points[b] - m_Points[a]));
    }
    return place->second;
  }

  const SurfaceMesh &                m_Mesh;
  std::vector<Vector3d>              m_Points;
  std::vector<double>                m_Values;
  std::map<std::pair<int, int>, int> m_Crossings;
};

/** Largest part of the surface where the function of position is positive, remeshed with this edge length. */
SurfaceMesh
PartWhere(const SurfaceMesh & mesh, const std::function<double(const Vector3d &)> & inside, double edge)
{
  SurfaceRemeshingSettings options;
  options.edgeLength = edge;
  return RemeshSurface(LargestComponent(RepairSurface(Clipper(mesh, inside).Positive())), options);
}
} // namespace

SignedDistance
Rod(const std::vector<Vector3d> & line, double radius)
{
  return [=](const Vector3d & p) {
    double nearest = 1e30;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      const Vector3d along = line[i + 1] - line[i];
      const double   share = std::clamp((p - line[i]).dot(along) / along.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (p - line[i] - share * along).norm());
    }
    return nearest - radius;
  };
}

SignedDistance
Joined(const std::vector<SignedDistance> & solids, double fillet)
{
  return [=](const Vector3d & p) {
    double distance = solids.front()(p);
    for (std::size_t i = 1; i < solids.size(); ++i)
    {
      const double other = solids[i](p);
      const double overlap = std::max(0.0, fillet - std::abs(distance - other)) / fillet;
      distance = std::min(distance, other) - 0.25 * fillet * overlap * overlap;
    }
    return distance;
  };
}

SurfaceMesh
SurfaceOfSolid(const SignedDistance & solid, const Vector3d & low, const Vector3d & high, double edge)
{
  const double               spacing = 0.7 * edge;
  auto                       occupancy = OccupancyImage::New();
  OccupancyImage::RegionType region;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    region.SetSize(axis, static_cast<itk::SizeValueType>(std::ceil((high[axis] - low[axis]) / spacing)) + 1);
  }
  occupancy->SetRegions(region);
  occupancy->SetSpacing(OccupancyImage::SpacingType(spacing));
  occupancy->SetOrigin(OccupancyImage::PointType(low.data()));
  occupancy->Allocate();
  float *    value = occupancy->GetBufferPointer();
  const auto size = region.GetSize();
  for (itk::SizeValueType z = 0; z < size[2]; ++z)
  {
    for (itk::SizeValueType y = 0; y < size[1]; ++y)
    {
      for (itk::SizeValueType x = 0; x < size[0]; ++x)
      {
        const double distance = solid(low + spacing * Vector3d(x, y, z));
        *value++ = static_cast<float>(std::clamp(0.5 - 0.25 * distance / spacing, 0.0, 1.0));
      }
    }
  }
  SurfaceRemeshingSettings options;
  options.edgeLength = edge;
  return RemeshSurface(ExtractWall(occupancy), options);
}

std::vector<int>
LoopAcross(const SurfaceMesh & mesh, const Vector3d & place, const Vector3d & normal, double radius)
{
  const SurfaceConnectivity       connectivity(mesh);
  std::map<int, std::vector<int>> next;
  const auto                      centerOf = [&](int face) -> Vector3d {
    return (mesh.V.row(mesh.F(face, 0)) + mesh.V.row(mesh.F(face, 1)) + mesh.V.row(mesh.F(face, 2))) / 3.0;
  };
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    const IndexRange faces = connectivity.FacesOfEdge(edge);
    if (faces.size() == 2)
    {
      const Vector3d a = centerOf(faces[0]) - place;
      const Vector3d b = centerOf(faces[1]) - place;
      if ((a.dot(normal) < 0.0) != (b.dot(normal) < 0.0) && std::max(a.norm(), b.norm()) < radius)
      {
        const auto & ends = connectivity.VerticesOfEdge(edge);
        next[ends[0]].push_back(ends[1]);
        next[ends[1]].push_back(ends[0]);
      }
    }
  }
  if (next.empty())
  {
    throw std::runtime_error("the surface does not cross the plane near the given point");
  }
  std::vector<int> loop{ next.begin()->first, next.begin()->second.front() };
  while (loop.back() != loop.front() && loop.size() <= next.size())
  {
    const std::vector<int> & ways = next[loop.back()];
    loop.push_back(ways.front() == loop[loop.size() - 2] ? ways.back() : ways.front());
  }
  if (loop.size() != next.size() + 1 || loop.back() != loop.front())
  {
    throw std::runtime_error("the surface crosses the plane in more than one loop");
  }
  return loop;
}

int
VertexAt(const SurfaceMesh & mesh, const Vector3d & place)
{
  Eigen::Index vertex = 0;
  (mesh.V.rowwise() - place.transpose()).rowwise().squaredNorm().minCoeff(&vertex);
  return static_cast<int>(vertex);
}

namespace
{
CutPair
CutApart(const SurfaceMesh & whole, const Vector3d & place, const Vector3d & normal, double radius)
{
  const SurfaceConnectivity connectivity(whole);
  return { whole, CutAlongPaths(whole, connectivity, { LoopAcross(whole, place, normal, radius) }).mesh };
}
} // namespace

CutPair
MakeHand(double edge)
{
  // Seen from the front, fingers up, the thumb on the right of the picture.
  const SignedDistance palm = Ellipsoid({ 0, 0, 0 }, { 40, 15, 46 });
  const SignedDistance wrist = Rod({ { 0, 0, -30 }, { 0, 0, -75 } }, 20);
  const SignedDistance fingers = Joined({ Rod({ { -28, 0, 22 }, { -44, 0, 78 } }, 7.5),
                                          Rod({ { -10, 0, 36 }, { -15, 0, 104 } }, 8.5),
                                          Rod({ { 9, 0, 36 }, { 13, 0, 110 } }, 8.5),
                                          Rod({ { 26, 0, 30 }, { 40, 0, 66 }, { 63.2, 0, 75.2 } }, 8.0),
                                          Rod({ { 26, 0, -20 }, { 60, 0, 10 }, { 72, 0, 62 } }, 9.0) },
                                        2.0);
  const SurfaceMesh    hand =
    SurfaceOfSolid(Joined({ palm, wrist, fingers }, 10.0), { -62, -30, -105 }, { 92, 30, 128 }, edge);
  const Vector3d thumb(72, 0, 62), index(63.2, 0, 75.2);
  return CutApart(hand, thumb + 0.54 * (index - thumb), index - thumb, 14.0);
}

Vector3d
LittleFingertip()
{
  return { -46, 0, 86 };
}

Vector3d
ThumbNail()
{
  return { 80, 0, 52 };
}

SurfaceMesh
MakeFace(double edge)
{
  const SignedDistance head = Ellipsoid({ 0, 0, 0 }, { 70, 85, 100 });
  const SignedDistance nose = Rod({ { 0, -82, 12 }, { 0, -96, -14 } }, 9);
  const SignedDistance brow = Rod({ { -34, -72, 34 }, { 0, -84, 36 }, { 34, -72, 34 } }, 7);
  const SignedDistance chin = Ellipsoid({ 0, -58, -78 }, { 24, 20, 18 });
  const SignedDistance cheeks =
    Joined({ Ellipsoid({ -32, -64, -22 }, { 18, 16, 18 }), Ellipsoid({ 32, -64, -22 }, { 18, 16, 18 }) }, 4);
  const SurfaceMesh surface =
    SurfaceOfSolid(Joined({ head, nose, brow, chin, cheeks }, 14.0), { -84, -120, -116 }, { 84, 100, 116 }, edge);
  return PartWhere(
    surface,
    [](const Vector3d & p) {
      const auto fromHole = [&](double x, double z, double width, double height) {
        return height * (std::hypot((p.x() - x) / width, (p.z() - z) / height) - 1.0);
      };
      return std::min({ -5.0 - p.y(), fromHole(-28, 16, 14, 8), fromHole(28, 16, 14, 8), fromHole(0, -46, 20, 7) });
    },
    edge);
}

HandledPatch
MakePotPatch(double edge)
{
  // A thick-walled pot around the z axis; the handle is at +x, on the right as seen from the front.
  const SignedDistance belly = Ellipsoid({ 0, 0, 0 }, { 60, 60, 70 });
  const SignedDistance handle =
    Rod({ { 48, 0, 28 }, { 76, 0, 30 }, { 92, 0, 8 }, { 80, 0, -18 }, { 50, 0, -26 } }, 6.5);
  const SurfaceMesh whole = SurfaceOfSolid(Joined({ belly, handle }, 10.0), { -66, -66, -78 }, { 112, 66, 78 }, edge);
  const double      half = 38.0, height = 44.0;
  const SurfaceMesh patch = PartWhere(
    whole,
    [&](const Vector3d & p) {
      return std::min({ p.x(), half - std::abs(p.y()), height - std::abs(p.z()) });
    },
    edge);
  HandledPatch              pot{ CutApart(patch, { 92, 0, 8 }, { 0, 0, 1 }, 14.0), {} };
  const SurfaceConnectivity connectivity(patch);
  const BoundaryLoop        rim = BoundaryLoopsByLength(connectivity, patch.V).front();
  const double places[4][2] = { { -half, -height }, { half, -height }, { half, height }, { -half, height } };
  for (int i = 0; i < 4; ++i)
  {
    const auto distanceTo = [&](int v) {
      return std::hypot(patch.V(v, 1) - places[i][0], patch.V(v, 2) - places[i][1]);
    };
    pot.corners[i] = *std::min_element(
      rim.vertices.begin(), rim.vertices.end(), [&](int v, int w) { return distanceTo(v) < distanceTo(w); });
  }
  return pot;
}
