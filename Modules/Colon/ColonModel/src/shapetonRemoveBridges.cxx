#include "shapetonRemoveBridges.h"

#include "shapetonSurfaceConnectivity.h"
#include "shapetonSurfaceRepair.h"

#include <array>
#include <cstdint>
#include <map>

namespace shapeton
{
namespace
{
using Position = std::array<double, 3>;

Position
PositionOf(const SurfaceMesh & mesh, Eigen::Index vertex)
{
  return { mesh.V(vertex, 0), mesh.V(vertex, 1), mesh.V(vertex, 2) };
}

/** Renumbers the vertices of the loops. */
void
RenumberLoops(const SurfaceMesh & before, SurfaceMesh & after)
{
  std::map<Position, int> vertexAt;
  for (int v = 0; v < after.NumberOfVertices(); ++v)
  {
    vertexAt.emplace(PositionOf(after, v), v);
  }
  for (SurfaceArray & array : after.fieldArrays)
  {
    if (array.name != "rectumLoop" && array.name != "cecumLoop")
    {
      continue;
    }
    for (Eigen::Index i = 0; i < array.values.rows(); ++i)
    {
      const auto found = vertexAt.find(PositionOf(before, static_cast<Eigen::Index>(array.values(i, 0))));
      array.values(i, 0) = found == vertexAt.end() ? -1.0 : found->second;
    }
  }
}

std::vector<int>
FacesOfPieces(const SurfaceMesh & mesh)
{
  constexpr std::int64_t    leastShare = 1000; // a thousandth of the faces
  const SurfaceConnectivity connectivity(mesh);
  std::vector<int>          kept;
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const auto & component = connectivity.Components()[connectivity.ComponentOfFaces()[f]];
    if (component.faces * leastShare >= mesh.NumberOfFaces())
    {
      kept.push_back(f);
    }
  }
  return kept;
}
} // namespace

SurfaceMesh
RemoveBridges(const SurfaceMesh & mesh)
{
  const SurfaceArray * const bridged = FindSurfaceArray(mesh.cellArrays, "bridged");
  std::vector<int>           lumen;
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    if (bridged->values(f, 0) == 0.0)
    {
      lumen.push_back(f);
    }
  }
  if (static_cast<int>(lumen.size()) == mesh.NumberOfFaces() || lumen.empty())
  {
    return mesh;
  }
  SurfaceRepairOptions repair; // separates faces connected only at a vertex
  repair.mergeVertices = false;
  repair.orient = false;
  SurfaceMesh pieces = RepairSurface(FacesOfSurface(mesh, lumen), repair);
  pieces = FacesOfSurface(pieces, FacesOfPieces(pieces));
  RenumberLoops(mesh, pieces);
  return pieces;
}
} // namespace shapeton
