#ifndef shapetonMeshAdapter_h
#define shapetonMeshAdapter_h

#include "shapetonMeshArrays.h"

#include "itkMesh.h"
#include "itkTriangleCell.h"

#include <map>
#include <type_traits>

namespace shapeton
{
/** A mesh type that preserves surfaces completely, with all arrays and double-precision positions (ITK's default meshes
 * use floats); used between filters. \ingroup ShapetonMeshBridge */
using PipelineMesh = itk::Mesh<itk::VariableLengthVector<double>,
                               3,
                               itk::DefaultStaticMeshTraits<itk::VariableLengthVector<double>,
                                                            3,
                                                            3,
                                                            double,
                                                            double,
                                                            itk::VariableLengthVector<double>>>;

/** \name Surfaces as itk::Mesh and itk::QuadEdgeMesh
 * TMesh has three dimensions and coordinates of any precision; positions are LPS, mm. Pixels of type
 * itk::VariableLengthVector store all arrays, with concatenated components; other pixels store one array. Names, field
 * arrays and facts are stored in the MetaDataDictionary. */
///@{
namespace meshadapter
{
constexpr const char * PointArrays = "shapeton.pointArrays";
constexpr const char * CellArrays = "shapeton.cellArrays";
constexpr const char * FieldArrays = "shapeton.fieldArrays";
constexpr const char * Facts = "shapeton.facts";
using FactList = std::vector<std::pair<std::string, std::string>>;

template <typename TMesh, typename = void>
struct IsQuadEdgeMesh : std::false_type
{};
template <typename TMesh>
struct IsQuadEdgeMesh<TMesh, std::void_t<typename TMesh::QEPrimal>> : std::true_type
{};

/** Adds a triangle and returns its cell identifier. */
template <typename TMesh>
typename TMesh::CellIdentifier
AddTriangle(const FaceMatrix & F, Eigen::Index face, TMesh & mesh)
{
  using Identifier = typename TMesh::PointIdentifier;
  if constexpr (IsQuadEdgeMesh<TMesh>::value)
  {
    const auto * const edge = mesh.AddFaceTriangle(
      static_cast<Identifier>(F(face, 0)), static_cast<Identifier>(F(face, 1)), static_cast<Identifier>(F(face, 2)));
    if (!edge)
    {
      throw InputError("the face " + std::to_string(face) +
                       " shares an edge with two others or is flipped: a QuadEdgeMesh must be an oriented manifold; "
                       "repair the surface first");
    }
    return edge->GetLeft();
  }
  else
  {
    typename TMesh::CellType::CellAutoPointer cell;
    cell.TakeOwnership(new itk::TriangleCell<typename TMesh::CellType>);
    for (int corner = 0; corner < 3; ++corner)
    {
      cell->SetPointId(corner, static_cast<Identifier>(F(face, corner)));
    }
    mesh.SetCell(static_cast<typename TMesh::CellIdentifier>(face), cell);
    return static_cast<typename TMesh::CellIdentifier>(face);
  }
}

template <typename TValue>
TValue
ValueOf(const itk::MetaDataDictionary & dictionary, const char * key)
{
  TValue value{};
  itk::ExposeMetaData(dictionary, key, value);
  return value;
}
} // namespace meshadapter

/** Fills an empty mesh.
 * \param pointArray, cellArray the arrays for pixels with a fixed number of components; empty for none.
 * Throws ParameterError if the mesh is not empty or an array does not exist; InputError as RequireSound() does, and for
 * a QuadEdgeMesh if the surface is not an oriented manifold. \ingroup ShapetonMeshBridge */
template <typename TMesh>
void
FillMesh(const SurfaceMesh & surface,
         TMesh &             mesh,
         const std::string & pointArray = "",
         const std::string & cellArray = "")
{
  static_assert(TMesh::PointDimension == 3, "surfaces are three-dimensional");
  RequireParameter(mesh.GetNumberOfPoints() == 0 && mesh.GetNumberOfCells() == 0,
                   "the mesh to be filled is not empty; call its Initialize() first");
  RequireSound(surface, "the surface");
  using PointPixel = typename TMesh::PixelType;
  using CellPixel = typename TMesh::CellPixelType;
  const auto pointArrays = mesharrays::ArraysForPixels<PointPixel>(surface.pointArrays, pointArray);
  const auto cellArrays = mesharrays::ArraysForPixels<CellPixel>(surface.cellArrays, cellArray);
  for (Eigen::Index v = 0; v < surface.V.rows(); ++v)
  {
    const auto                point = static_cast<typename TMesh::PointIdentifier>(v);
    typename TMesh::PointType place;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      place[axis] = static_cast<typename TMesh::PointType::ValueType>(surface.V(v, axis));
    }
    mesh.SetPoint(point, place);
    if (!pointArrays.empty())
    {
      mesh.SetPointData(point, mesharrays::PixelOf<PointPixel>(pointArrays, v));
    }
  }
  for (Eigen::Index f = 0; f < surface.F.rows(); ++f)
  {
    const auto cell = meshadapter::AddTriangle(surface.F, f, mesh);
    if (!cellArrays.empty())
    {
      mesh.SetCellData(cell, mesharrays::PixelOf<CellPixel>(cellArrays, f));
    }
  }
  auto & dictionary = mesh.GetMetaDataDictionary();
  itk::EncapsulateMetaData(dictionary, meshadapter::PointArrays, mesharrays::LayoutOf(pointArrays));
  itk::EncapsulateMetaData(dictionary, meshadapter::CellArrays, mesharrays::LayoutOf(cellArrays));
  itk::EncapsulateMetaData(dictionary, meshadapter::FieldArrays, surface.fieldArrays);
  itk::EncapsulateMetaData(dictionary, meshadapter::Facts, surface.facts);
}

namespace meshadapter
{
/** Positions, values and the row of each point identifier; identifiers may have gaps. */
template <typename TMesh>
std::map<typename TMesh::PointIdentifier, int>
TakePoints(const TMesh & mesh, SurfaceMesh & surface)
{
  std::map<typename TMesh::PointIdentifier, int> rows;
  surface.V.resize(static_cast<Eigen::Index>(mesh.GetNumberOfPoints()), 3);
  mesharrays::ArrayReader<typename TMesh::PixelType> arrays(
    ValueOf<std::string>(mesh.GetMetaDataDictionary(), PointArrays), "pointData", surface.V.rows());
  for (auto point = mesh.GetPoints()->Begin(); point != mesh.GetPoints()->End(); ++point)
  {
    const auto row = static_cast<int>(rows.size());
    rows.emplace_hint(rows.end(), point.Index(), row);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      surface.V(row, axis) = point.Value()[axis];
    }
    if (mesh.GetPointData() && mesh.GetPointData()->IndexExists(point.Index()))
    {
      arrays.Take(row, mesh.GetPointData()->ElementAt(point.Index()));
    }
  }
  surface.pointArrays = arrays.Arrays();
  return rows;
}

/** Identifiers of the triangles. */
template <typename TMesh>
std::vector<typename TMesh::CellIdentifier>
TrianglesOf(const TMesh & mesh)
{
  std::vector<typename TMesh::CellIdentifier> triangles;
  for (auto cell = mesh.GetCells()->Begin(); cell != mesh.GetCells()->End(); ++cell)
  {
    const auto dimension = cell.Value()->GetDimension();
    const auto corners = cell.Value()->GetNumberOfPoints();
    if (dimension > 2 || (dimension == 2 && corners != 3))
    {
      throw InputError("the cell " + std::to_string(cell.Index()) + " of the mesh has " + std::to_string(corners) +
                       " points; triangulate the mesh");
    }
    if (dimension == 2)
    {
      triangles.push_back(cell.Index());
    }
  }
  return triangles;
}

template <typename TMesh>
void
TakeTriangles(const TMesh & mesh, const std::map<typename TMesh::PointIdentifier, int> & rows, SurfaceMesh & surface)
{
  const auto triangles = TrianglesOf(mesh);
  surface.F.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  mesharrays::ArrayReader<typename TMesh::CellPixelType> arrays(
    ValueOf<std::string>(mesh.GetMetaDataDictionary(), CellArrays), "cellData", surface.F.rows());
  for (Eigen::Index face = 0; face < surface.F.rows(); ++face)
  {
    const auto identifier = triangles[static_cast<std::size_t>(face)];
    const auto cell = mesh.GetCells()->ElementAt(identifier);
    int        corner = 0;
    for (auto point = cell->PointIdsBegin(); point != cell->PointIdsEnd(); ++point)
    {
      const auto row = rows.find(*point);
      if (row == rows.end())
      {
        throw InputError("the cell " + std::to_string(identifier) + " of the mesh refers to the point " +
                         std::to_string(*point) + ", which does not exist");
      }
      surface.F(face, corner++) = row->second;
    }
    if (mesh.GetCellData() && mesh.GetCellData()->IndexExists(identifier))
    {
      arrays.Take(face, mesh.GetCellData()->ElementAt(identifier));
    }
  }
  surface.cellArrays = arrays.Arrays();
}
} // namespace meshadapter

/** Converts the triangles of a mesh to a surface, points and cells by ascending identifier. Vertices and lines are
 * dropped. Values with unknown names, or replaced by a filter, become one array named pointData or cellData. Throws
 * InputError for polygons with more than three points, solids, cells with missing points, and the exceptions of
 * RequireSound(). \ingroup ShapetonMeshBridge */
template <typename TMesh, typename = typename TMesh::MeshTraits>
SurfaceMesh
SurfaceOf(const TMesh & mesh)
{
  static_assert(TMesh::PointDimension == 3, "surfaces are three-dimensional");
  if (!mesh.GetPoints() || !mesh.GetCells())
  {
    throw InputError("the mesh is empty");
  }
  SurfaceMesh surface;
  meshadapter::TakeTriangles(mesh, meshadapter::TakePoints(mesh, surface), surface);
  const auto & dictionary = mesh.GetMetaDataDictionary();
  surface.fieldArrays = meshadapter::ValueOf<std::vector<SurfaceArray>>(dictionary, meshadapter::FieldArrays);
  surface.facts = meshadapter::ValueOf<meshadapter::FactList>(dictionary, meshadapter::Facts);
  RequireSound(surface, "the mesh");
  return surface;
}
///@}
} // namespace shapeton

#endif
