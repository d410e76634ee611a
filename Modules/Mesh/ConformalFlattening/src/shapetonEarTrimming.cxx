#include "shapetonTubeEnds.h"

#include "shapetonDisjointSets.h"
#include "shapetonSurfaceQuality.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** For each vertex, the number of its boundary loop, counted from 1; 0 inside. */
std::vector<int>
EndOfVertices(const SurfaceConnectivity & connectivity)
{
  std::vector<int> ends(connectivity.NumberOfVertices(), 0);
  for (std::size_t i = 0; i < connectivity.BoundaryLoops().size(); ++i)
  {
    for (const int v : connectivity.BoundaryLoops()[i])
    {
      ends[v] = static_cast<int>(i) + 1;
    }
  }
  return ends;
}

/** Faces of the largest part left when edges within one end split the surface; ascending. */
std::vector<int>
FacesWithoutEars(const SurfaceConnectivity & connectivity)
{
  const std::vector<int> ends = EndOfVertices(connectivity);
  DisjointSets           parts(connectivity.NumberOfFaces());
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    const auto & [a, b] = connectivity.VerticesOfEdge(edge);
    const IndexRange faces = connectivity.FacesOfEdge(edge);
    if (faces.size() == 2 && (ends[a] == 0 || ends[a] != ends[b]))
    {
      parts.Join(faces[0], faces[1]);
    }
  }
  std::vector<int> sizes(connectivity.NumberOfFaces(), 0);
  for (int face = 0; face < connectivity.NumberOfFaces(); ++face)
  {
    ++sizes[parts.Find(face)];
  }
  const auto       greatest = static_cast<int>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  std::vector<int> faces;
  for (int face = 0; face < connectivity.NumberOfFaces(); ++face)
  {
    if (parts.Find(face) == greatest)
    {
      faces.push_back(face);
    }
  }
  return faces;
}

/** New index of each vertex if only these faces remain, or -1 if it is removed. */
std::vector<int>
NumbersOfVertices(const SurfaceMesh & mesh, const std::vector<int> & faces)
{
  std::vector<int> numbers(mesh.NumberOfVertices(), -1);
  for (const int face : faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      numbers[mesh.F(face, k)] = 0;
    }
  }
  int next = 0;
  for (int & number : numbers)
  {
    number = number == 0 ? next++ : -1;
  }
  return numbers;
}

/** The remaining vertices of an end form the new end, in their order. */
void
TrimLoop(const std::vector<int> & numbers, SurfaceArray & array)
{
  std::vector<double> left;
  for (Eigen::Index i = 0; i < array.values.rows(); ++i)
  {
    const auto v = static_cast<std::size_t>(array.values(i, 0));
    if (v < numbers.size() && numbers[v] != -1)
    {
      left.push_back(numbers[v]);
    }
  }
  array.values = Eigen::Map<Eigen::VectorXd>(left.data(), static_cast<Eigen::Index>(left.size()));
}

bool
IsTube(const SurfaceMesh & mesh)
{
  const SurfaceConnectivity connectivity(mesh);
  return connectivity.IsManifold() && connectivity.BoundaryLoops().size() == 2;
}
} // namespace

TrimmedTube
TrimEars(SurfaceMesh mesh, const SurfaceConnectivity & connectivity)
{
  const std::vector<int> faces = FacesWithoutEars(connectivity);
  TrimmedTube            trimmed;
  if (static_cast<int>(faces.size()) < mesh.NumberOfFaces())
  {
    SurfaceMesh rest = FacesOfSurface(mesh, faces);
    if (IsTube(rest))
    {
      const std::vector<int> numbers = NumbersOfVertices(mesh, faces);
      for (SurfaceArray & array : rest.fieldArrays)
      {
        if (array.name == "rectumLoop" || array.name == "cecumLoop")
        {
          TrimLoop(numbers, array);
        }
      }
      trimmed.faces = mesh.NumberOfFaces() - rest.NumberOfFaces();
      trimmed.area = SurfaceArea(mesh.V, mesh.F) - SurfaceArea(rest.V, rest.F);
      mesh = std::move(rest);
    }
  }
  trimmed.mesh = std::move(mesh);
  return trimmed;
}
} // namespace shapeton
