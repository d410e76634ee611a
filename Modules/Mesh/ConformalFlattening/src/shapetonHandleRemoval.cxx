#include "shapetonSurfaceHandles.h"

#include "shapetonHoleFilling.h"
#include "shapetonExceptions.h"
#include "shapetonTubeEnds.h"

#include <algorithm>
#include <set>

namespace shapeton
{
namespace
{
constexpr const char * filledName = "filled";

/** Faces to delete: those of the vertices of handles, but for vertices next to a boundary. */
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
        throw InputError("a handle names vertex " + std::to_string(v) + ", which the surface has not");
      }
      const std::vector<int> around = connectivity.NeighboursOfVertex(v);
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

/** The number of edges of a vertex with a deleted face on one side only. */
int
RimsAtVertex(const SurfaceConnectivity & connectivity, int vertex, const std::vector<char> & isDeleted)
{
  int rims = 0;
  for (const int other : connectivity.NeighboursOfVertex(vertex))
  {
    const IndexRange faces = connectivity.FacesOfEdge(connectivity.FindEdge(vertex, other));
    rims += faces.size() == 2 && isDeleted[faces[0]] != isDeleted[faces[1]] ? 1 : 0;
  }
  return rims;
}

/** Deletes further faces until at each vertex the rest is one fan. */
void
OpenPinches(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, std::vector<char> & isDeleted)
{
  std::set<int> open;
  const auto    addCorners = [&](int face) {
    for (int k = 0; k < 3; ++k)
    {
      open.insert(mesh.F(face, k));
    }
  };
  for (int face = 0; face < mesh.NumberOfFaces(); ++face)
  {
    if (isDeleted[face])
    {
      addCorners(face);
    }
  }
  while (!open.empty())
  {
    const int vertex = *open.begin();
    open.erase(open.begin());
    if (!connectivity.IsBoundaryVertex(vertex) && RimsAtVertex(connectivity, vertex, isDeleted) > 2)
    {
      for (const int face : connectivity.FacesOfVertex(vertex))
      {
        isDeleted[face] = 1;
        addCorners(face);
      }
    }
  }
}

/** The rest of the surface, its greatest component. */
SurfaceMesh
KeptSurface(const SurfaceMesh & mesh, const std::vector<char> & isDeleted)
{
  std::vector<int> kept;
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    if (!isDeleted[f])
    {
      kept.push_back(f);
    }
  }
  SurfaceMesh               rest = FacesOfSurface(mesh, kept);
  const SurfaceConnectivity connectivity(rest);
  const auto &              components = connectivity.Components();
  if (components.size() < 2)
  {
    return rest;
  }
  const auto greatest = std::max_element(
    components.begin(), components.end(), [](const auto & a, const auto & b) { return a.faces < b.faces; });
  kept.clear();
  for (int f = 0; f < rest.NumberOfFaces(); ++f)
  {
    if (connectivity.ComponentOfFaces()[f] == greatest - components.begin())
    {
      kept.push_back(f);
    }
  }
  return FacesOfSurface(rest, kept);
}

/** Those that are not at the boundaries of the surface before, by the positions of their vertices. */
std::vector<std::vector<int>>
NewLoops(const SurfaceMesh &         before,
         const SurfaceConnectivity & connectivity,
         const SurfaceMesh &         rest,
         const SurfaceConnectivity & connectivityOfRest)
{
  std::set<std::array<double, 3>> rims;
  const auto                      positionOf = [](const SurfaceMesh & mesh, int v) {
    return std::array<double, 3>{ mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2) };
  };
  for (const std::vector<int> & loop : connectivity.BoundaryLoops())
  {
    for (const int v : loop)
    {
      rims.insert(positionOf(before, v));
    }
  }
  std::vector<std::vector<int>> loops;
  for (const std::vector<int> & loop : connectivityOfRest.BoundaryLoops())
  {
    if (rims.count(positionOf(rest, loop.front())) == 0)
    {
      loops.push_back(loop);
    }
  }
  return loops;
}

Eigen::RowVectorXd
MeanOfRows(const Eigen::Ref<const SurfaceArray::ValueMatrix> & values, const std::vector<int> & rows)
{
  Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(values.cols());
  for (const int row : rows)
  {
    mean += values.row(row) / static_cast<double>(rows.size());
  }
  return mean;
}

/** Rows for the new vertices: means over the rims. */
template <typename TMatrix>
void
AppendRimMeans(TMatrix & values, const std::vector<HoleFilling> & fillings, bool areIntegers)
{
  Eigen::Index number = values.rows();
  for (const HoleFilling & filling : fillings)
  {
    number += filling.numberOfVertices;
  }
  values.conservativeResize(number, Eigen::NoChange);
  for (const HoleFilling & filling : fillings)
  {
    Eigen::RowVectorXd mean = MeanOfRows(values, filling.rim);
    if (areIntegers)
    {
      mean = mean.array().round().matrix().eval();
    }
    values.middleRows(filling.firstVertex, filling.numberOfVertices).rowwise() = mean;
  }
}

void
AppendFaces(SurfaceMesh & mesh, const std::vector<HoleFilling> & fillings, int added)
{
  Eigen::Index next = mesh.F.rows();
  mesh.F.conservativeResize(next + added, Eigen::NoChange);
  for (const HoleFilling & filling : fillings)
  {
    for (const auto & [a, b, c] : filling.faces)
    {
      mesh.F.row(next++) << a, b, c;
    }
  }
  for (SurfaceArray & array : mesh.cellArrays)
  {
    array.values.conservativeResize(next, Eigen::NoChange);
    array.values.bottomRows(added).setConstant(array.name == filledName ? 1.0 : 0.0);
  }
}
} // namespace

HandleRemoval
RemoveHandles(const SurfaceMesh &                mesh,
              const SurfaceConnectivity &        connectivity,
              const std::vector<SurfaceHandle> & handles)
{
  RequireOneManifold(connectivity, "the surface with handles");
  std::vector<char> isDeleted = FacesOfHandles(connectivity, handles);
  OpenPinches(mesh, connectivity, isDeleted);
  HandleRemoval removal;
  removal.mesh = KeptSurface(mesh, isDeleted);
  removal.removedFaces = mesh.NumberOfFaces() - removal.mesh.NumberOfFaces();
  if (!FindSurfaceArray(removal.mesh.cellArrays, filledName))
  {
    removal.mesh.cellArrays.push_back(
      { filledName, SurfaceArray::ValueMatrix::Zero(removal.mesh.NumberOfFaces(), 1), true });
  }
  RenumberLoopArrays(mesh, removal.mesh);
  const SurfaceConnectivity rest(removal.mesh);
  std::vector<HoleFilling>  fillings;
  int                       nextVertex = removal.mesh.NumberOfVertices();
  for (const std::vector<int> & loop : NewLoops(mesh, connectivity, removal.mesh, rest))
  {
    fillings.push_back(TriangulateHole(loop, removal.mesh.V, rest, nextVertex));
    nextVertex += fillings.back().numberOfVertices;
    removal.filledFaces += static_cast<int>(fillings.back().faces.size());
  }
  AppendFaces(removal.mesh, fillings, removal.filledFaces);
  AppendRimMeans(removal.mesh.V, fillings, false);
  for (SurfaceArray & array : removal.mesh.pointArrays)
  {
    AppendRimMeans(array.values, fillings, array.areIntegers);
  }
  removal.filledHoles = static_cast<int>(fillings.size());
  const SurfaceConnectivity closed(removal.mesh);
  RequireOneManifold(closed, "the surface without handles");
  for (const HoleFilling & filling : fillings)
  {
    SmoothFilling(filling, closed, removal.mesh.V);
  }
  removal.genus = closed.Components().front().genus.value_or(0);
  return removal;
}
} // namespace shapeton
