#include "shapetonSurfaceFormats.h"
#include "shapetonExceptions.h"

#include <algorithm>

namespace shapeton
{
using Arrays = std::vector<SurfaceArray>;

void
RequireRows(const Arrays & arrays, Eigen::Index rows, const std::string & what)
{
  for (const SurfaceArray & array : arrays)
  {
    if (array.values.rows() != rows)
    {
      throw InputError(what + ": the array \"" + array.name + "\" has " + std::to_string(array.values.rows()) +
                       " rows for " + std::to_string(rows) + " elements; give one row for each");
    }
  }
}

Arrays
RowsOfArrays(const Arrays & arrays, const std::vector<int> & rows)
{
  Arrays chosen;
  for (const SurfaceArray & array : arrays)
  {
    SurfaceArray part{ array.name, {}, array.areIntegers };
    part.values.resize(static_cast<Eigen::Index>(rows.size()), array.values.cols());
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      part.values.row(static_cast<Eigen::Index>(i)) = array.values.row(rows[i]);
    }
    chosen.push_back(std::move(part));
  }
  return chosen;
}

void
RequireFinite(const VertexMatrix & V, Eigen::Index v, const std::string & what)
{
  if (!V.row(v).allFinite())
  {
    throw InputError(what + ": vertex " + std::to_string(v) + " has a coordinate that is not finite; correct it");
  }
}

const SurfaceArray *
FindSurfaceArray(const Arrays & arrays, const std::string & name)
{
  const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const auto & array) { return array.name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

void
RequireSound(const SurfaceMesh & mesh, const std::string & what)
{
  if (mesh.NumberOfFaces() == 0)
  {
    throw InputError(what + ": there are no faces; use a surface of triangles or polygons");
  }
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (mesh.F(f, k) < 0 || mesh.F(f, k) >= mesh.NumberOfVertices())
      {
        throw InputError(what + ": face " + std::to_string(f) + " refers to vertex " + std::to_string(mesh.F(f, k)) +
                         ", but there are " + std::to_string(mesh.NumberOfVertices()) + "; correct it");
      }
      RequireFinite(mesh.V, mesh.F(f, k), what);
    }
  }
  RequireRows(mesh.pointArrays, mesh.V.rows(), what);
  RequireRows(mesh.cellArrays, mesh.F.rows(), what);
}

std::array<Eigen::RowVector3d, 2>
CornersOfFaces(const SurfaceMesh & mesh)
{
  std::array<Eigen::RowVector3d, 2> corners{ mesh.V.row(mesh.F(0, 0)), mesh.V.row(mesh.F(0, 0)) };
  for (Eigen::Index i = 1; i < mesh.F.size(); ++i)
  {
    const Eigen::RowVector3d vertex = mesh.V.row(mesh.F.data()[i]);
    corners[0] = corners[0].cwiseMin(vertex);
    corners[1] = corners[1].cwiseMax(vertex);
  }
  return corners;
}

SurfaceMesh
FacesOfSurface(const SurfaceMesh & mesh, const std::vector<int> & faces)
{
  std::vector<int> newIndex(mesh.V.rows(), -1);
  for (const int f : faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      newIndex[mesh.F(f, k)] = 0;
    }
  }
  std::vector<int> vertices;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (newIndex[v] == 0)
    {
      newIndex[v] = static_cast<int>(vertices.size());
      vertices.push_back(v);
    }
  }
  SurfaceMesh part;
  part.V.resize(static_cast<Eigen::Index>(vertices.size()), 3);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    part.V.row(static_cast<Eigen::Index>(i)) = mesh.V.row(vertices[i]);
  }
  part.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      part.F(static_cast<Eigen::Index>(i), k) = newIndex[mesh.F(faces[i], k)];
    }
  }
  part.pointArrays = RowsOfArrays(mesh.pointArrays, vertices);
  part.cellArrays = RowsOfArrays(mesh.cellArrays, faces);
  part.fieldArrays = mesh.fieldArrays;
  part.facts = mesh.facts;
  return part;
}
} // namespace shapeton
