#include "shapetonFaceReplacement.h"

#include "shapetonSurfaceLaplacian.h"
#include "shapetonTubeEnds.h"

#include <algorithm>
#include <set>

namespace shapeton
{
namespace
{
/** Number of edges of a vertex with a deleted face on exactly one side. */
int
RimsAtVertex(const SurfaceConnectivity & connectivity, int vertex, const std::vector<char> & isDeleted)
{
  int rims = 0;
  for (const int other : connectivity.NeighborsOfVertex(vertex))
  {
    const IndexRange faces = connectivity.FacesOfEdge(connectivity.FindEdge(vertex, other));
    rims += faces.size() == 2 && isDeleted[faces[0]] != isDeleted[faces[1]] ? 1 : 0;
  }
  return rims;
}

/** Remaining faces of the largest component, ascending. */
std::vector<int>
KeptFaces(const SurfaceMesh & mesh, const std::vector<char> & isDeleted)
{
  std::vector<int> kept;
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    if (!isDeleted[f])
    {
      kept.push_back(f);
    }
  }
  const SurfaceConnectivity connectivity(FacesOfSurface(mesh, kept));
  const auto &              components = connectivity.Components();
  const auto                greatest = std::max_element(
    components.begin(), components.end(), [](const auto & a, const auto & b) { return a.faces < b.faces; });
  std::vector<int> faces;
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    if (connectivity.ComponentOfFaces()[i] == greatest - components.begin())
    {
      faces.push_back(kept[i]);
    }
  }
  return faces;
}

/** The vertices used by these faces, ascending: vertex i of FacesOfSurface() is element i. */
std::vector<int>
VerticesOfFaces(const SurfaceMesh & mesh, const std::vector<int> & faces)
{
  std::vector<char> isNamed(mesh.NumberOfVertices(), 0);
  for (const int face : faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      isNamed[mesh.F(face, k)] = 1;
    }
  }
  std::vector<int> vertices;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (isNamed[v])
    {
      vertices.push_back(v);
    }
  }
  return vertices;
}

/** Loops that are not boundaries of the original surface, by the positions of their vertices. */
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

/** Appends rows for the new vertices: means over the rims. */
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
AppendFaces(SurfaceMesh & mesh, const std::vector<HoleFilling> & fillings, int added, const std::string & markName)
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
    array.values.bottomRows(added).setConstant(array.name == markName ? 1.0 : 0.0);
  }
}
} // namespace

void
OpenPinches(const FaceMatrix & F, const SurfaceConnectivity & connectivity, std::vector<char> & isDeleted)
{
  std::set<int> open;
  const auto    addCorners = [&](int face) {
    for (int k = 0; k < 3; ++k)
    {
      open.insert(F(face, k));
    }
  };
  for (int face = 0; face < connectivity.NumberOfFaces(); ++face)
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

std::vector<HoleFilling>
FillHoles(SurfaceMesh &                         mesh,
          const SurfaceConnectivity &           connectivity,
          const std::vector<std::vector<int>> & loops,
          const std::string &                   markName)
{
  if (!FindSurfaceArray(mesh.cellArrays, markName))
  {
    mesh.cellArrays.push_back({ markName, SurfaceArray::ValueMatrix::Zero(mesh.NumberOfFaces(), 1), true });
  }
  std::vector<HoleFilling> fillings;
  int                      nextVertex = mesh.NumberOfVertices();
  for (const std::vector<int> & loop : loops)
  {
    fillings.push_back(TriangulateHole(loop, mesh.V, connectivity, nextVertex));
    nextVertex += fillings.back().numberOfVertices;
  }
  AppendFaces(mesh, fillings, NumberOfFilledFaces(fillings), markName);
  AppendRimMeans(mesh.V, fillings, false);
  for (SurfaceArray & array : mesh.pointArrays)
  {
    AppendRimMeans(array.values, fillings, array.areIntegers);
  }
  const SurfaceConnectivity closed(mesh);
  RequireOneManifold(closed, "the surface with its holes filled");
  for (const HoleFilling & filling : fillings)
  {
    SmoothFilling(filling, closed, mesh.V);
  }
  return fillings;
}

int
NumberOfFilledFaces(const std::vector<HoleFilling> & fillings)
{
  int number = 0;
  for (const HoleFilling & filling : fillings)
  {
    number += static_cast<int>(filling.faces.size());
  }
  return number;
}

FaceReplacement
ReplaceFaces(const SurfaceMesh &         mesh,
             const SurfaceConnectivity & connectivity,
             const std::vector<char> &   isDeleted,
             const std::string &         markName)
{
  const std::vector<int> kept = KeptFaces(mesh, isDeleted);
  FaceReplacement        result{ FacesOfSurface(mesh, kept), VerticesOfFaces(mesh, kept), {} };
  RenumberLoopArrays(mesh, result.mesh);
  const SurfaceConnectivity rest(result.mesh);
  result.fillings = FillHoles(result.mesh, rest, NewLoops(mesh, connectivity, result.mesh, rest), markName);
  return result;
}
} // namespace shapeton
