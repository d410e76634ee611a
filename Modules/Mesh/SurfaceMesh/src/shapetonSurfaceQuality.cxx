#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceRepair.h"
#include "shapetonVertexMerging.h"
#include "shapetonParallelFor.h"
#include "shapetonPi.h"
#include "shapetonQuantiles.h"
#include "shapetonSurfaceFormats.h"
#include "shapetonTriangleShape.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace shapeton
{
namespace
{
constexpr double LeastHeight = 1e-12; // relative to the longest side

struct Triangle
{
  Eigen::Vector3d a, b, c;
};

Triangle
TriangleOf(const VertexMatrix & V, const FaceMatrix & F, int f)
{
  return { V.row(F(f, 0)), V.row(F(f, 1)), V.row(F(f, 2)) };
}

bool
NamesAVertexTwice(const FaceMatrix & F, int f)
{
  return F(f, 0) == F(f, 1) || F(f, 1) == F(f, 2) || F(f, 2) == F(f, 0);
}

bool
HasNoArea(const Triangle & t)
{
  const double longest = std::max({ (t.b - t.a).squaredNorm(), (t.c - t.b).squaredNorm(), (t.a - t.c).squaredNorm() });
  return !(DoubleAreaNormal(t.a, t.b, t.c).norm() > LeastHeight * longest);
}

std::array<int, 3>
SortedVertices(const FaceMatrix & F, int f)
{
  std::array<int, 3> vertices{ F(f, 0), F(f, 1), F(f, 2) };
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

/** Whether the face may be a duplicate: always true for faces with a repeated vertex, which are not compared. */
bool
MayBeDuplicate(const FaceMatrix & F, const SurfaceConnectivity & connectivity, int f)
{
  const int edge = connectivity.EdgeOfFace(f, 0);
  if (edge < 0)
  {
    return true;
  }
  const IndexRange others = connectivity.FacesOfEdge(edge);
  return std::any_of(others.begin(), others.end(), [&](int other) {
    return other != f && SortedVertices(F, other) == SortedVertices(F, f);
  });
}

std::vector<int>
DuplicateFaces(const FaceMatrix & F, const SurfaceConnectivity & connectivity)
{
  std::vector<std::pair<std::array<int, 3>, int>> keys; // sorted vertices and face
  for (int f = 0; f < F.rows(); ++f)
  {
    if (MayBeDuplicate(F, connectivity, f))
    {
      keys.emplace_back(SortedVertices(F, f), f);
    }
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> duplicates;
  for (std::size_t i = 1; i < keys.size(); ++i)
  {
    if (keys[i].first == keys[i - 1].first)
    {
      duplicates.push_back(keys[i].second);
    }
  }
  std::sort(duplicates.begin(), duplicates.end());
  return duplicates;
}

std::vector<int>
CoincidentVertices(const SurfaceMesh & mesh)
{
  const std::vector<int> firsts = FirstAtPosition(mesh);
  std::vector<int>       coincident;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (firsts[v] != v)
    {
      coincident.push_back(v);
    }
  }
  return coincident;
}

std::vector<int>
UnreferencedVertices(const SurfaceMesh & mesh)
{
  std::vector<bool> isNamed(mesh.V.rows(), false);
  for (Eigen::Index i = 0; i < mesh.F.size(); ++i)
  {
    isNamed[mesh.F.data()[i]] = true;
  }
  std::vector<int> unreferenced;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (!isNamed[v])
    {
      unreferenced.push_back(v);
    }
  }
  return unreferenced;
}

void
MeasureFaces(const SurfaceMesh & mesh, SurfaceQuality & quality)
{
  constexpr double    none = -1.0;
  std::vector<double> smallest(mesh.F.rows());
  std::vector<double> largest(mesh.F.rows());
  std::vector<double> aspects(mesh.F.rows(), none);
  ParallelForBlocks(smallest.size(), [&](std::size_t f) {
    const Triangle t = TriangleOf(mesh.V, mesh.F, static_cast<int>(f));
    const double   angles[] = { AngleAt(t.a, t.b, t.c), AngleAt(t.b, t.c, t.a), AngleAt(t.c, t.a, t.b) };
    smallest[f] = DegreesPerRadian * *std::min_element(angles, angles + 3);
    largest[f] = DegreesPerRadian * *std::max_element(angles, angles + 3);
    aspects[f] = HasNoArea(t) ? none : AspectRatio(t.a, t.b, t.c);
  });
  aspects.erase(std::remove(aspects.begin(), aspects.end(), none), aspects.end());
  quality.smallestAngle = StatisticsOf(std::move(smallest));
  quality.largestAngle = StatisticsOf(std::move(largest));
  quality.aspectRatio = StatisticsOf(std::move(aspects));
}

void
MeasureEdges(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, SurfaceQuality & quality)
{
  std::vector<double> lengths(connectivity.NumberOfEdges());
  ParallelForBlocks(lengths.size(), [&](std::size_t e) {
    const auto & ends = connectivity.VerticesOfEdge(static_cast<int>(e));
    lengths[e] = (mesh.V.row(ends[0]) - mesh.V.row(ends[1])).norm();
  });
  quality.edgeLength = StatisticsOf(std::move(lengths));
  for (const auto & loop : connectivity.BoundaryLoops())
  {
    double length = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const int next = loop[(i + 1) % loop.size()];
      if (connectivity.FindEdge(loop[i], next) >= 0) // false at the end of an open chain
      {
        length += (mesh.V.row(loop[i]) - mesh.V.row(next)).norm();
      }
    }
    quality.boundaryLoopLengths.push_back(length);
    quality.boundaryLoopVertices.push_back(static_cast<int>(loop.size()));
  }
}

void
DescribeTopology(const SurfaceConnectivity & connectivity, SurfaceQuality & quality)
{
  quality.components = connectivity.Components();
  quality.isManifold = connectivity.IsManifold();
  quality.isClosed = connectivity.IsClosed();
  quality.isOriented = connectivity.IsOriented();
  quality.genus = quality.components.empty() ? std::optional<int>() : 0;
  for (const SurfaceComponent & component : quality.components)
  {
    quality.genus =
      quality.genus && component.genus ? std::optional<int>(*quality.genus + *component.genus) : std::optional<int>();
  }
  int vertices = 0;
  for (int v = 0; v < connectivity.NumberOfVertices(); ++v)
  {
    vertices += connectivity.FacesOfVertex(v).size() > 0;
  }
  int faces = 0;
  for (const SurfaceComponent & component : quality.components)
  {
    faces += component.faces;
  }
  quality.edges = connectivity.NumberOfEdges();
  quality.eulerCharacteristic = vertices - quality.edges + faces;
}
} // namespace

bool
SurfaceDefects::AreNone() const
{
  return degenerateFaces.empty() && zeroAreaFaces.empty() && duplicateFaces.empty() && unreferencedVertices.empty() &&
         nonManifoldEdges.empty() && nonManifoldVertices.empty() && inconsistentEdges.empty();
}

SurfaceDefects
FindSurfaceDefects(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity)
{
  SurfaceDefects defects;
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    if (NamesAVertexTwice(mesh.F, f))
    {
      defects.degenerateFaces.push_back(f);
    }
    else if (HasNoArea(TriangleOf(mesh.V, mesh.F, f)))
    {
      defects.zeroAreaFaces.push_back(f);
    }
  }
  defects.duplicateFaces = DuplicateFaces(mesh.F, connectivity);
  defects.unreferencedVertices = UnreferencedVertices(mesh);
  defects.coincidentVertices = CoincidentVertices(mesh);
  for (int e = 0; e < connectivity.NumberOfEdges(); ++e)
  {
    if (connectivity.IsNonManifoldEdge(e))
    {
      defects.nonManifoldEdges.push_back(e);
    }
    else if (connectivity.IsInconsistentEdge(e))
    {
      defects.inconsistentEdges.push_back(e);
    }
  }
  const int vertices = connectivity.IsManifold() ? 0 : mesh.NumberOfVertices(); // to check
  for (int v = 0; v < vertices; ++v)
  {
    if (connectivity.IsNonManifoldVertex(v))
    {
      defects.nonManifoldVertices.push_back(v);
    }
  }
  return defects;
}

SurfaceStatistics
StatisticsOf(std::vector<double> values)
{
  SurfaceStatistics statistics;
  if (values.empty())
  {
    return statistics;
  }
  statistics.minimum = *std::min_element(values.begin(), values.end());
  constexpr double percent = 0.01;
  statistics.percentile1 = InterpolatedQuantile(values, percent);
  statistics.median = InterpolatedQuantile(values, 0.5);
  statistics.percentile99 = InterpolatedQuantile(values, 1.0 - percent);
  statistics.maximum = *std::max_element(values.begin(), values.end());
  return statistics;
}

VertexMatrix
VertexNormals(const VertexMatrix & V, const FaceMatrix & F)
{
  VertexMatrix normals = VertexMatrix::Zero(V.rows(), 3);
  for (Eigen::Index f = 0; f < F.rows(); ++f)
  {
    const Triangle        t = TriangleOf(V, F, static_cast<int>(f));
    const Eigen::Vector3d normal = (t.b - t.a).cross(t.c - t.a);
    for (int k = 0; k < 3; ++k)
    {
      normals.row(F(f, k)) += normal;
    }
  }
  for (Eigen::Index i = 0; i < normals.rows(); ++i)
  {
    normals.row(i).normalize(); // keeps zeros, unlike rowwise()
  }
  return normals;
}

double
SurfaceArea(const VertexMatrix & V, const FaceMatrix & F)
{
  double area = 0.0;
  for (int f = 0; f < F.rows(); ++f)
  {
    const Triangle t = TriangleOf(V, F, f);
    area += 0.5 * DoubleAreaNormal(t.a, t.b, t.c).norm();
  }
  return area;
}

double
EnclosedVolume(const VertexMatrix & V, const FaceMatrix & F)
{
  if (F.rows() == 0)
  {
    return 0.0;
  }
  const Eigen::Vector3d origin = V.row(F(0, 0)); // near the surface, which reduces cancellation
  double                volume = 0.0;
  for (int f = 0; f < F.rows(); ++f)
  {
    const Triangle t = TriangleOf(V, F, f);
    volume += (t.a - origin).dot((t.b - origin).cross(t.c - origin)) / 6.0;
  }
  return volume;
}

SurfaceQuality
InspectSurface(const SurfaceMesh & mesh)
{
  RequireSound(mesh, "the surface");
  const SurfaceConnectivity connectivity(mesh);
  SurfaceQuality            quality;
  quality.vertices = mesh.NumberOfVertices();
  quality.faces = mesh.NumberOfFaces();
  DescribeTopology(connectivity, quality);
  quality.area = SurfaceArea(mesh.V, mesh.F);
  if (quality.isClosed && quality.isOriented)
  {
    quality.volume = EnclosedVolume(mesh.V, mesh.F);
  }
  const auto corners = CornersOfFaces(mesh);
  quality.lowestCorner = corners[0];
  quality.highestCorner = corners[1];
  MeasureEdges(mesh, connectivity, quality);
  MeasureFaces(mesh, quality);
  quality.defects = FindSurfaceDefects(mesh, connectivity);
  for (const int edge : quality.defects.nonManifoldEdges)
  {
    const auto & ends = connectivity.VerticesOfEdge(edge);
    quality.nonManifoldEdges.push_back({ mesh.V.row(ends[0]), mesh.V.row(ends[1]) });
  }
  if (!quality.defects.coincidentVertices.empty() || !quality.defects.nonManifoldVertices.empty())
  {
    quality.componentsAfterRepair = SurfaceConnectivity(RepairSurface(mesh)).Components();
  }
  return quality;
}
} // namespace shapeton
