#include "shapetonSurfaceHandles.h"

#include "shapetonFaceReplacement.h"
#include "shapetonExceptions.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** Faces to delete: faces of handle vertices, except for vertices next to a boundary. */
std::vector<char>
FacesOfHandles(const SurfaceConnectivity & connectivity, const std::vector<SurfaceHandle> & handles)
{
  std::vector<char> isRim(connectivity.NumberOfVertices(), 0);
  for (const std::vector<int> & loop : connectivity.BoundaryLoops())
  {
    for (const int v : loop)
    {
      isRim[v] = 1;
    }
  }
  std::vector<char> isDeleted(connectivity.NumberOfFaces(), 0);
  for (const SurfaceHandle & handle : handles)
  {
    for (const int v : handle.vertices)
    {
      if (v < 0 || v >= connectivity.NumberOfVertices())
      {
        throw InputError("a handle refers to vertex " + std::to_string(v) + ", which does not exist");
      }
      const std::vector<int> around = connectivity.NeighborsOfVertex(v);
      const bool             isNearRim =
        isRim[v] || std::any_of(around.begin(), around.end(), [&](int other) { return isRim[other]; });
      for (const int face : isNearRim ? IndexRange(nullptr, nullptr) : connectivity.FacesOfVertex(v))
      {
        isDeleted[face] = 1;
      }
    }
  }
  return isDeleted;
}
} // namespace

HandleRemoval
RemoveHandles(const SurfaceMesh &                mesh,
              const SurfaceConnectivity &        connectivity,
              const std::vector<SurfaceHandle> & handles)
{
  RequireOneManifold(connectivity, "the surface with handles");
  std::vector<char> isDeleted = FacesOfHandles(connectivity, handles);
  OpenPinches(mesh.F, connectivity, isDeleted);
  FaceReplacement replacement = ReplaceFaces(mesh, connectivity, isDeleted, filledName);
  HandleRemoval   removal;
  removal.mesh = std::move(replacement.mesh);
  removal.filledHoles = static_cast<int>(replacement.fillings.size());
  removal.filledFaces = NumberOfFilledFaces(replacement.fillings);
  removal.removedFaces = mesh.NumberOfFaces() + removal.filledFaces - removal.mesh.NumberOfFaces();
  removal.genus = SurfaceConnectivity(removal.mesh).Components().front().genus.value_or(0);
  return removal;
}
} // namespace shapeton
