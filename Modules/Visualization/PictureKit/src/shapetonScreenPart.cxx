#include "shapetonScreenPart.h"

#include "shapetonParallelFor.h"
#include "shapetonSurfaceQuality.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using Row = Eigen::RowVector3d;

Row
RowOf(const itk::Vector<double, 3> & vector)
{
  return { vector[0], vector[1], vector[2] };
}
} // namespace

int
ScreenPlace(double pixel)
{
  // Far outside any picture, but small enough for products of two differences in 64 bits.
  constexpr double limit = 1 << 28;
  return static_cast<int>(std::lround(std::clamp((pixel + 0.5) * samplesAlongPixel * subsamples, -limit, limit)));
}

ScreenPart
ProjectMesh(const SurfaceMesh & mesh, const PatientView & view)
{
  const VertexMatrix           normals = VertexNormals(mesh.V, mesh.F);
  const Row                    right = RowOf(view.GetRight());
  const Row                    up = RowOf(view.GetUp());
  const Row                    forward = RowOf(view.GetForward());
  const itk::Vector<double, 3> center = view.PointOfPixel(0.0, 0.0).GetVectorFromOrigin();
  const double                 originDepth = center * view.GetForward();

  ScreenPart part;
  part.faces = &mesh.F;
  part.vertices.resize(mesh.V.rows());
  ParallelForBlocks(part.vertices.size(), [&](std::size_t i) {
    const Row  p = mesh.V.row(i);
    const Row  n = normals.row(i);
    const auto place = view.Project(PatientView::PointType{ p.data() });
    part.vertices[i] = {
      ScreenPlace(place[0]),
      ScreenPlace(place[1]),
      static_cast<float>(p.dot(forward) - originDepth),
      { static_cast<float>(n.dot(right)), static_cast<float>(n.dot(up)), static_cast<float>(-n.dot(forward)) }
    };
  });
  return part;
}
} // namespace shapeton
