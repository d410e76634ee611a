#ifndef shapetonIntrinsicSurfaces_h
#define shapetonIntrinsicSurfaces_h

#include "shapetonSurfaceLaplacian.h"
#include "shapetonTestSurfaces.h"

/** Laplacians of surfaces, and flat surfaces defined by edge lengths, with closed-form spectra. */
namespace testsurfaces
{
inline shapeton::SurfaceLaplacian
LaplacianOf(const shapeton::SurfaceMesh & mesh, const shapeton::SurfaceLaplacianOptions & options = {})
{
  return shapeton::MakeSurfaceLaplacian(shapeton::SurfaceConnectivity(mesh), mesh.V, options);
}

/** A grid with its planar edge lengths, independent of wrapping. */
struct FlatGrid
{
  FlatGrid(int around, int along, Wrap wrap, double width, double height)
    : mesh(Grid(around, along, wrap, [](double s, double t) { return Eigen::Vector3d(s, t, 0.0); }))
    , connectivity(mesh)
    , lengths(connectivity.NumberOfEdges())
  {
    const double dx = width / around;
    const double dy = height / along;
    for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
    {
      const auto &          ends = connectivity.VerticesOfEdge(edge);
      const Eigen::Vector3d step = (mesh.V.row(ends[0]) - mesh.V.row(ends[1])).cwiseAbs();
      const bool            isAcross = step.x() > 1e-9;
      const bool            isAlong = step.y() > 1e-9;
      lengths[edge] = std::hypot(isAcross ? dx : 0.0, isAlong ? dy : 0.0);
    }
  }
  shapeton::SurfaceLaplacian
  Laplacian() const
  {
    return shapeton::MakeSurfaceLaplacian(connectivity, lengths);
  }

  shapeton::SurfaceMesh         mesh;
  shapeton::SurfaceConnectivity connectivity;
  Eigen::VectorXd               lengths;
};
} // namespace testsurfaces

#endif
