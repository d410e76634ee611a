#include "shapetonCentrelineGeometry.h"
#include "shapetonColonWall.h"
#include "shapetonDisjointSets.h"
#include "shapetonExceptions.h"
#include "shapetonParallelFor.h"

#include <vtkCellArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <mutex>
#include <stdexcept>

namespace shapeton
{
namespace
{
constexpr float WallLevel = 0.5F;
/** Values keep so far from the level: several edges that cross it at one voxel would give faces without area. */
constexpr float LeastStep = 0.001F;

/** Mirrored at the level where it is on the wrong side. */
float
ClampedValue(float value, bool isLumen)
{
  const float mirrored = isLumen == (value >= WallLevel) ? value : 1.0F - value;
  return isLumen ? std::max(mirrored, WallLevel + LeastStep) : std::min(mirrored, WallLevel - LeastStep);
}

/** The field with a layer of zeros around, clamped to the mask, in index coordinates. */
void
CopyField(const OccupancyImage * occupancy, const LumenMaskImage * mask, vtkImageData * field)
{
  const auto size = occupancy->GetBufferedRegion().GetSize();
  field->SetDimensions(static_cast<int>(size[0]) + 2, static_cast<int>(size[1]) + 2, static_cast<int>(size[2]) + 2);
  field->SetOrigin(-1.0, -1.0, -1.0);
  field->AllocateScalars(VTK_FLOAT, 1);
  auto * const                values = static_cast<float *>(field->GetScalarPointer());
  const float * const         from = occupancy->GetBufferPointer();
  const unsigned char * const isIn = mask == nullptr ? nullptr : mask->GetBufferPointer();
  const std::size_t           slice = (size[0] + 2) * (size[1] + 2);
  ParallelFor(size[2] + 2, [&](std::size_t z) {
    std::fill_n(values + z * slice, slice, 0.0F);
    for (std::size_t y = 0; y < size[1] && z > 0 && z <= size[2]; ++y)
    {
      float * const row = values + z * slice + (y + 1) * (size[0] + 2) + 1;
      std::size_t   i = ((z - 1) * size[1] + y) * size[0];
      for (std::size_t x = 0; x < size[0]; ++x, ++i)
      {
        row[x] = ClampedValue(from[i], isIn == nullptr ? from[i] >= WallLevel : isIn[i] != 0);
      }
    }
  });
}

/** One at a time: VTK's choice of threads is that of the whole process. */
void
UpdateOnOneThread(vtkFlyingEdges3D * contour)
{
  static std::mutex                 mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  // VTK's other backends have thread counts of their own, and warn on stderr when they change.
  vtkSMPTools::LocalScope(vtkSMPTools::Config(std::string("Sequential")), [contour] { contour->Update(); });
}

/** The contour in LPS mm. */
SurfaceMesh
ContourOf(const OccupancyImage * occupancy, const LumenMaskImage * mask)
{
  vtkNew<vtkImageData> field;
  CopyField(occupancy, mask, field);
  const GridGeometry       grid(occupancy);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(field);
  contour->SetValue(0, WallLevel);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  UpdateOnOneThread(contour);

  vtkPolyData * surface = contour->GetOutput();
  SurfaceMesh   mesh;
  mesh.V.resize(surface->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Eigen::Vector3d index;
    surface->GetPoint(i, index.data());
    mesh.V.row(i) = grid.PointOf(index);
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

/** For each vertex the least vertex of its component. */
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

/** The component that encloses most, with its faces outwards. */
SurfaceMesh
OuterShell(const SurfaceMesh & mesh)
{
  const std::vector<int> component = ComponentOfVertices(mesh);
  std::vector<double>    volumes(component.size(), 0.0);
  const Eigen::Vector3d  centre = mesh.V.colwise().mean();
  for (Eigen::Index f = 0; f < mesh.F.rows(); ++f)
  {
    const Eigen::Vector3d a = mesh.V.row(mesh.F(f, 0)).transpose() - centre;
    const Eigen::Vector3d b = mesh.V.row(mesh.F(f, 1)).transpose() - centre;
    const Eigen::Vector3d c = mesh.V.row(mesh.F(f, 2)).transpose() - centre;
    volumes[component[mesh.F(f, 0)]] += a.dot(b.cross(c));
  }
  const auto greatest =
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
} // namespace

SurfaceMesh
ExtractWall(const OccupancyImage * occupancy, const LumenMaskImage * mask)
{
  if (mask != nullptr && mask->GetBufferedRegion().GetSize() != occupancy->GetBufferedRegion().GetSize())
  {
    throw std::invalid_argument("The occupancy and the mask have different sizes");
  }
  const SurfaceMesh mesh = ContourOf(occupancy, mask);
  if (mesh.NumberOfFaces() == 0)
  {
    throw InputError("the lumen has no wall: no voxel has an occupancy of at least 0.5");
  }
  return OuterShell(mesh);
}
} // namespace shapeton
