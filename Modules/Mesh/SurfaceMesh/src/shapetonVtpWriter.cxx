#include "shapetonExceptions.h"
#include "shapetonFileBytes.h"
#include "shapetonPolyDataContent.h"
#include "shapetonPrintable.h"
#include "shapetonSurfaceFormats.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>

namespace shapeton
{
namespace
{
/** VTK does not escape names, which would make the file invalid. */
void
RequireName(const std::string & name)
{
  const bool isFit = std::none_of(name.begin(), name.end(), [](unsigned char c) {
    return c < 0x20 || c == 0x7F || c == '"' || c == '<' || c == '>' || c == '&';
  });
  if (!isFit)
  {
    throw InputError("the array " + Quoted(Printable(name)) +
                     " has a control character or one of \" < > & in its name, which VTP does not allow; rename it");
  }
}

template <typename TArray>
vtkSmartPointer<vtkDataArray>
Filled(const SurfaceArray & array)
{
  auto filled = vtkSmartPointer<TArray>::New();
  filled->SetName(array.name.c_str());
  filled->SetNumberOfComponents(static_cast<int>(array.values.cols()));
  filled->SetNumberOfTuples(array.values.rows());
  for (Eigen::Index i = 0; i < array.values.size(); ++i)
  {
    filled->SetValue(i, static_cast<typename TArray::ValueType>(array.values.data()[i]));
  }
  return filled;
}

void
AddArrays(const std::vector<SurfaceArray> & arrays, vtkFieldData & data)
{
  for (const SurfaceArray & array : arrays)
  {
    RequireName(array.name);
    if (array.values.cols() == 0)
    {
      throw InputError("the array " + Quoted(array.name) + " has no columns; omit it");
    }
    data.AddArray(array.areIntegers ? Filled<vtkIntArray>(array) : Filled<vtkDoubleArray>(array));
  }
}

void
AddFact(const std::string & name, const std::string & value, vtkFieldData & data)
{
  RequireName(name);
  if (value.find('\0') != std::string::npos)
  {
    throw InputError("the fact " + Quoted(name) + " contains a zero byte, which VTP does not allow; omit it");
  }
  vtkNew<vtkStringArray> fact;
  fact->SetName(name.c_str());
  fact->InsertNextValue(value);
  data.AddArray(fact);
}

/** Points, arrays and facts of a surface or of curves; no cells. */
template <typename TGeometry>
void
FillWithoutCells(const TGeometry & geometry, vtkPolyData & data)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(geometry.V.rows());
  for (Eigen::Index v = 0; v < geometry.V.rows(); ++v)
  {
    points->SetPoint(v, geometry.V(v, 0), geometry.V(v, 1), geometry.V(v, 2));
  }
  data.Initialize();
  data.SetPoints(points);
  AddArrays(geometry.pointArrays, *data.GetPointData());
  AddArrays(geometry.cellArrays, *data.GetCellData());
  AddArrays(geometry.fieldArrays, *data.GetFieldData());
  AddFact(VtpSpaceName, "LPS", *data.GetFieldData());
  for (const auto & [name, value] : geometry.facts)
  {
    AddFact(name, value, *data.GetFieldData());
  }
}

vtkSmartPointer<vtkCellArray>
PolysOf(const FaceMatrix & F)
{
  auto polys = vtkSmartPointer<vtkCellArray>::New();
  polys->AllocateExact(F.rows(), F.size());
  for (Eigen::Index f = 0; f < F.rows(); ++f)
  {
    const vtkIdType corners[] = { F(f, 0), F(f, 1), F(f, 2) };
    polys->InsertNextCell(3, corners);
  }
  return polys;
}

void
Write(vtkPolyData * data, const std::string & path)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->WriteToOutputStringOn();
  writer->SetHeaderTypeToUInt64();
  writer->SetCompressionLevel(1); // level 5 takes twice as long for 1 % less
  writer->Write();
  WriteFileBytes(path, writer->GetOutputString());
}
} // namespace

void
FillPolyData(const SurfaceMesh & mesh, vtkPolyData & data)
{
  FillWithoutCells(mesh, data);
  data.SetPolys(PolysOf(mesh.F));
}

void
FillPolyData(const CurveSet & curves, const FaceMatrix & faces, vtkPolyData & data)
{
  FillWithoutCells(curves, data);
  vtkNew<vtkCellArray>   verts;
  vtkNew<vtkCellArray>   lines;
  std::vector<vtkIdType> ids;
  for (const std::vector<int> & curve : curves.curves)
  {
    ids.assign(curve.begin(), curve.end());
    (ids.size() == 1 ? verts : lines)->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  data.SetVerts(verts);
  data.SetLines(lines);
  if (faces.rows() > 0)
  {
    data.SetPolys(PolysOf(faces));
  }
}

void
WriteVtp(const SurfaceMesh & mesh, const std::string & path)
{
  vtkNew<vtkPolyData> data;
  FillPolyData(mesh, *data);
  Write(data, path);
}

void
WriteVtp(const CurveSet & curves, const FaceMatrix & faces, const std::string & path)
{
  vtkNew<vtkPolyData> data;
  FillPolyData(curves, faces, *data);
  Write(data, path);
}
} // namespace shapeton
