// Simplification of a bumpy sphere compared with its peers in one process: VTK's quadric decimation and CGAL's edge
// collapse (Lindstrom-Turk, link condition). Prints times, properties of the results, and the ratios of medians.
#include "Times.h"

#include "shapetonQuantiles.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceSimplification.h"
#include "shapetonTestSurfaces.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>

#include <functional>
#include <vector>

namespace
{
using shapeton::SurfaceMesh;

constexpr int    Repetitions = 3;
constexpr double KeptShare = 0.1;

/** Sphere of 327,680 faces with bumps of several sizes. */
SurfaceMesh
MakeSurface()
{
  SurfaceMesh mesh = testsurfaces::Icosphere(7, 100.0);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const Eigen::RowVector3d p = mesh.V.row(v);
    mesh.V.row(v) *= 1.0 + 0.03 * std::sin(0.2 * p.x()) * std::sin(0.23 * p.y()) + 0.01 * std::sin(0.7 * p.z());
  }
  return mesh;
}

SurfaceMesh
SimplifyByUs(const SurfaceMesh & mesh)
{
  shapeton::SurfaceSimplificationSettings options;
  options.faces = static_cast<int>(KeptShare * mesh.NumberOfFaces());
  return shapeton::SimplifySurface(mesh, options);
}

SurfaceMesh
SimplifyByVtk(const SurfaceMesh & mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    points->InsertNextPoint(mesh.V.row(v).data());
  }
  vtkNew<vtkCellArray> faces;
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    faces->InsertNextCell({ mesh.F(f, 0), mesh.F(f, 1), mesh.F(f, 2) });
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(faces);
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputData(data);
  decimation->SetTargetReduction(1.0 - KeptShare);
  decimation->Update();
  vtkPolyData * const output = decimation->GetOutput();
  SurfaceMesh         result;
  result.V.resize(output->GetNumberOfPoints(), 3);
  for (vtkIdType v = 0; v < output->GetNumberOfPoints(); ++v)
  {
    result.V.row(v) = Eigen::Map<const Eigen::RowVector3d>(output->GetPoint(v));
  }
  result.F.resize(output->GetNumberOfPolys(), 3);
  for (vtkIdType f = 0; f < output->GetNumberOfPolys(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      result.F(f, k) = static_cast<int>(output->GetCell(f)->GetPointId(k));
    }
  }
  return result;
}

SurfaceMesh
SimplifyByCgal(const SurfaceMesh & mesh)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  Mesh peer;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    peer.add_vertex(Point(mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)));
  }
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    peer.add_face(Mesh::Vertex_index(mesh.F(f, 0)), Mesh::Vertex_index(mesh.F(f, 1)), Mesh::Vertex_index(mesh.F(f, 2)));
  }
  CGAL::Surface_mesh_simplification::edge_collapse(
    peer, CGAL::Surface_mesh_simplification::Count_ratio_stop_predicate<Mesh>(KeptShare));
  peer.collect_garbage();
  SurfaceMesh result;
  result.V.resize(static_cast<Eigen::Index>(peer.number_of_vertices()), 3);
  result.F.resize(static_cast<Eigen::Index>(peer.number_of_faces()), 3);
  for (const auto v : peer.vertices())
  {
    const Point & p = peer.point(v);
    result.V.row(static_cast<Eigen::Index>(v)) << p.x(), p.y(), p.z();
  }
  for (const auto f : peer.faces())
  {
    int k = 0;
    for (const auto v : peer.vertices_around_face(peer.halfedge(f)))
    {
      result.F(static_cast<Eigen::Index>(f), k++) = static_cast<int>(v);
    }
  }
  return result;
}

/** Median time in seconds; prints the properties of the result. */
double
Measure(const char * name, const SurfaceMesh & mesh, const std::function<SurfaceMesh(const SurfaceMesh &)> & simplify)
{
  Times       times;
  SurfaceMesh result;
  for (int i = 0; i < Repetitions; ++i)
  {
    times.Measure([&] { result = simplify(mesh); });
  }
  const double                   seconds = shapeton::UpperMedian(times.elapsed);
  const shapeton::SurfaceQuality quality = shapeton::InspectSurface(result);
  std::printf(
    "%-22s %8.2f s  %7d faces  manifold %-3s  Euler characteristic %d  smallest angle, 1st percentile %.1f degrees\n",
    name,
    seconds,
    quality.faces,
    quality.isManifold ? "yes" : "no",
    quality.eulerCharacteristic,
    quality.smallestAngle.percentile1);
  return seconds;
}
} // namespace

int
main()
{
  const SurfaceMesh mesh = MakeSurface();
  std::printf("%d faces to a tenth\n", mesh.NumberOfFaces());
  const double ours = Measure("SimplifySurface", mesh, SimplifyByUs);
  const double vtk = Measure("vtkQuadricDecimation", mesh, SimplifyByVtk);
  const double cgal = Measure("CGAL edge_collapse", mesh, SimplifyByCgal);
  std::printf("ours / VTK: %.2f, ours / CGAL: %.2f\n", ours / vtk, ours / cgal);
  return 0;
}
