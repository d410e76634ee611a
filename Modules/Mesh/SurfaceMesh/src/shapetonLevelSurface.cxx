#include "shapetonLevelSurface.h"

#include "shapetonDisjointSets.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>

namespace shapeton
{
namespace
{
SurfaceMesh
MeshOf(vtkPolyData * surface)
{
  SurfaceMesh mesh;
  mesh.V.resize(surface->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    surface->GetPoint(i, mesh.V.row(i).data());
  }
  mesh.F.resize(surface->GetNumberOfPolys(), 3);
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    vtkIdType         corners = 0;
    const vtkIdType * ids = nullptr;
    surface->GetPolys()->GetCellAtId(i, corners, ids);
    mesh.F.row(i) << static_cast<int>(ids[0]), static_cast<int>(ids[1]), static_cast<int>(ids[2]);
  }
  return mesh;
}

/** Serializes the calls, because VTK's thread settings are process-wide. */
void
UpdateOnOneThread(vtkFlyingEdges3D * contour)
{
  static std::mutex                 mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  // VTK's other backends have separate thread counts, and warn on stderr when these change.
  vtkSMPTools::LocalScope(vtkSMPTools::Config(std::string("Sequential")), [contour] { contour->Update(); });
}

/** For each vertex, the lowest vertex of its component. */
std::vector<int>
ComponentOfVertices(const SurfaceMesh & mesh)
{
  DisjointSets components(mesh.NumberOfVertices());
  for (Eigen::Index f = 0; f < mesh.F.rows(); ++f)
  {
    components.Join(mesh.F(f, 0), mesh.F(f, 1));
    components.Join(mesh.F(f, 0), mesh.F(f, 2));
  }
  std::vector<int> least(mesh.NumberOfVertices());
  for (int i = 0; i < mesh.NumberOfVertices(); ++i)
  {
    least[i] = components.Find(i);
  }
  return least;
}

/** Six times the enclosed volume of each component, stored at its lowest vertex; negative if its faces point inward. */
std::vector<double>
VolumesOfComponents(const SurfaceMesh & mesh, const std::vector<int> & component)
{
  std::vector<double>   volumes(component.size(), 0.0);
  const Eigen::Vector3d center = mesh.V.colwise().mean();
  for (Eigen::Index f = 0; f < mesh.F.rows(); ++f)
  {
    const Eigen::Vector3d a = mesh.V.row(mesh.F(f, 0)).transpose() - center;
    const Eigen::Vector3d b = mesh.V.row(mesh.F(f, 1)).transpose() - center;
    const Eigen::Vector3d c = mesh.V.row(mesh.F(f, 2)).transpose() - center;
    volumes[component[mesh.F(f, 0)]] += a.dot(b.cross(c));
  }
  return volumes;
}
} // namespace

SurfaceMesh
LevelSurface(std::vector<float> & values, const std::array<int, 3> & size, double level, double first)
{
  if (values.size() != static_cast<std::size_t>(size[0]) * size[1] * size[2])
  {
    throw std::invalid_argument("The number of values does not match the grid size");
  }
  vtkNew<vtkFloatArray> scalars;
  scalars->SetArray(values.data(), static_cast<vtkIdType>(values.size()), 1); // VTK does not take ownership
  vtkNew<vtkImageData> field;
  field->SetDimensions(size.data());
  field->SetOrigin(first, first, first);
  field->GetPointData()->SetScalars(scalars);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(field);
  contour->SetValue(0, level);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  UpdateOnOneThread(contour);
  return MeshOf(contour->GetOutput());
}

SurfaceMesh
OuterShell(const SurfaceMesh & mesh)
{
  const std::vector<int>    component = ComponentOfVertices(mesh);
  const std::vector<double> volumes = VolumesOfComponents(mesh, component);
  const auto                greatest =
    std::max_element(volumes.begin(), volumes.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  const auto       best = static_cast<int>(greatest - volumes.begin());
  std::vector<int> faces;
  for (Eigen::Index f = 0; f < mesh.F.rows(); ++f)
  {
    if (component[mesh.F(f, 0)] == best)
    {
      faces.push_back(static_cast<int>(f));
    }
  }
  SurfaceMesh shell = FacesOfSurface(mesh, faces);
  if (*greatest < 0.0)
  {
    shell.F.col(1).swap(shell.F.col(2));
  }
  return shell;
}
} // namespace shapeton
