#include "shapetonPolyDataAdapter.h"

#include "shapetonExceptions.h"
#include "shapetonPolyDataContent.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkTriangleFilter.h>

#include <cstdint>
#include <limits>

namespace shapeton
{
namespace
{
void
TurnAround(vtkPoints & points)
{
  for (vtkIdType i = 0; i < points.GetNumberOfPoints(); ++i)
  {
    double place[3];
    points.GetPoint(i, place);
    points.SetPoint(i, -place[0], -place[1], place[2]);
  }
}

void
Enter(PatientSpace space, vtkPolyData & data)
{
  if (space == PatientSpace::RAS)
  {
    TurnAround(*data.GetPoints());
    SetSpace(space, *data.GetFieldData());
  }
}

VertexMatrix
VerticesOf(vtkPolyData & data, PatientSpace space)
{
  VertexMatrix V(data.GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i)
  {
    data.GetPoint(i, V.row(i).data());
  }
  if (space == PatientSpace::RAS)
  {
    V.leftCols<2>() *= -1.0;
  }
  return V;
}

/** Whether to set SurfaceArray::areIntegers; such arrays are written with 32 bits. */
bool
HoldsIntegers(vtkDataArray & array, const SurfaceArray::ValueMatrix & values)
{
  const int type = array.GetDataType();
  return type != VTK_FLOAT && type != VTK_DOUBLE &&
         (values.size() == 0 || (values.minCoeff() >= std::numeric_limits<std::int32_t>::min() &&
                                 values.maxCoeff() <= std::numeric_limits<std::int32_t>::max()));
}

/** The numeric arrays, restricted to the tuples from `begin` to `end`. */
std::vector<SurfaceArray>
ArraysOf(vtkFieldData & data, vtkIdType begin, vtkIdType end)
{
  std::vector<SurfaceArray> arrays;
  for (int i = 0; i < data.GetNumberOfArrays(); ++i)
  {
    vtkDataArray * const array = data.GetArray(i);
    if (!array)
    {
      continue;
    }
    const char * const        name = array->GetName();
    SurfaceArray::ValueMatrix values(end - begin, array->GetNumberOfComponents());
    for (vtkIdType row = begin; row < end; ++row)
    {
      array->GetTuple(row, values.row(row - begin).data());
    }
    const bool areIntegers = HoldsIntegers(*array, values);
    arrays.push_back({ name ? name : "array" + std::to_string(i), std::move(values), areIntegers });
  }
  return arrays;
}

/** Field arrays may have any number of rows. */
template <typename TGeometry>
void
TakeFieldData(vtkFieldData & data, TGeometry & geometry)
{
  for (int i = 0; i < data.GetNumberOfArrays(); ++i)
  {
    vtkNew<vtkFieldData> alone;
    alone->AddArray(data.GetAbstractArray(i));
    auto * const text = vtkStringArray::SafeDownCast(data.GetAbstractArray(i));
    if (text && text->GetName() && std::string(text->GetName()) != "SPACE" && text->GetNumberOfValues() > 0)
    {
      geometry.facts.emplace_back(text->GetName(), text->GetValue(0));
    }
    else if (!text)
    {
      const auto arrays = ArraysOf(*alone, 0, data.GetAbstractArray(i)->GetNumberOfTuples());
      geometry.fieldArrays.insert(geometry.fieldArrays.end(), arrays.begin(), arrays.end());
    }
  }
}

/** Converts points and arrays, except cell arrays. */
template <typename TGeometry>
TGeometry
WithoutCells(vtkPolyData & data, PatientSpace space)
{
  TGeometry geometry;
  geometry.V = VerticesOf(data, SpaceOf(*data.GetFieldData(), space));
  geometry.pointArrays = ArraysOf(*data.GetPointData(), 0, data.GetNumberOfPoints());
  TakeFieldData(*data.GetFieldData(), geometry);
  return geometry;
}

/** The curves, and the cell of each. */
class CurveReader
{
public:
  explicit CurveReader(CurveSet & curves) : m_Curves(curves) {}

  /** Adds a cell with several points as one curve, or as one curve per point if they are not connected. */
  void
  Append(vtkCellArray & cells, bool areLoose)
  {
    for (vtkIdType i = 0; i < cells.GetNumberOfCells(); ++i, ++m_Cells)
    {
      vtkIdType         number = 0;
      const vtkIdType * ids = nullptr;
      cells.GetCellAtId(i, number, ids);
      const vtkIdType length = areLoose ? 1 : number;
      for (vtkIdType first = 0; first < number; first += length)
      {
        m_Curves.curves.emplace_back(ids + first, ids + first + length);
        m_CellOfCurve.push_back(m_Cells);
      }
    }
  }

  void
  TakeCellData(vtkFieldData & data)
  {
    for (SurfaceArray & array : ArraysOf(data, 0, m_Cells))
    {
      SurfaceArray::ValueMatrix values(static_cast<Eigen::Index>(m_CellOfCurve.size()), array.values.cols());
      for (Eigen::Index curve = 0; curve < values.rows(); ++curve)
      {
        values.row(curve) = array.values.row(m_CellOfCurve[static_cast<std::size_t>(curve)]);
      }
      m_Curves.cellArrays.push_back({ array.name, std::move(values), array.areIntegers });
    }
  }

private:
  CurveSet &             m_Curves;
  vtkIdType              m_Cells{ 0 };
  std::vector<vtkIdType> m_CellOfCurve;
};
} // namespace

vtkSmartPointer<vtkPolyData>
PolyDataOf(const SurfaceMesh & mesh, PatientSpace space)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  FillPolyData(mesh, *data);
  Enter(space, *data);
  return data;
}

vtkSmartPointer<vtkPolyData>
PolyDataOf(const CurveSet & curves, PatientSpace space)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  FillPolyData(curves, {}, *data);
  Enter(space, *data);
  return data;
}

SurfaceMesh
SurfaceOf(vtkPolyData & data, PatientSpace space)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(&data);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  vtkPolyData & cut = *triangles->GetOutput();
  if (cut.GetNumberOfPolys() == 0)
  {
    throw InputError("the vtkPolyData has no polygons; a surface is required");
  }
  auto mesh = WithoutCells<SurfaceMesh>(data, space);
  mesh.F.resize(cut.GetNumberOfPolys(), 3);
  for (vtkIdType i = 0; i < cut.GetNumberOfPolys(); ++i)
  {
    vtkIdType         number = 0;
    const vtkIdType * ids = nullptr;
    cut.GetPolys()->GetCellAtId(i, number, ids);
    mesh.F.row(i) << static_cast<int>(ids[0]), static_cast<int>(ids[1]), static_cast<int>(ids[2]);
  }
  mesh.cellArrays = ArraysOf(*cut.GetCellData(), 0, cut.GetNumberOfPolys());
  RequireSound(mesh, "the vtkPolyData");
  return mesh;
}

CurveSet
CurvesOf(vtkPolyData & data, PatientSpace space)
{
  auto        curves = WithoutCells<CurveSet>(data, space);
  CurveReader reader(curves);
  reader.Append(*data.GetVerts(), true);
  reader.Append(*data.GetLines(), false);
  reader.TakeCellData(*data.GetCellData());
  RequireSound(curves, "the vtkPolyData");
  return curves;
}
} // namespace shapeton
