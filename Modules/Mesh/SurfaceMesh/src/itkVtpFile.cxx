#include "itkFileBytes.h"
#include "itkSurfaceFormats.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <charconv>
#include <new>

namespace itk
{
namespace
{
constexpr const char * SpaceName = "SPACE"; // where 3D Slicer looks for LPS or RAS
constexpr std::size_t  BestCompression = 1100;

/** Keeps VTK's errors, which would go to stderr, as long as it lives. */
class VTKErrors
{
public:
  VTKErrors() : m_Before(vtkOutputWindow::GetInstance()), m_Verbosity(vtkLogger::GetCurrentVerbosityCutoff())
  {
    vtkOutputWindow::SetInstance(m_Window);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~VTKErrors()
  {
    vtkLogger::SetStderrVerbosity(m_Verbosity);
    vtkOutputWindow::SetInstance(m_Before);
  }
  VTKErrors(const VTKErrors &) = delete;
  VTKErrors &
  operator=(const VTKErrors &) = delete;

  bool
  WereThere() const
  {
    return m_Window->wereThere;
  }

private:
  class Window : public vtkOutputWindow
  {
  public:
    vtkTypeMacro(Window, vtkOutputWindow);
    static Window *
    New();
    void
    DisplayText(const char *) override
    {}
    void
    DisplayErrorText(const char *) override
    {
      wereThere = true;
    }
    bool wereThere{ false };
  };

  vtkNew<Window>                   m_Window;
  vtkSmartPointer<vtkOutputWindow> m_Before;
  vtkLogger::Verbosity             m_Verbosity;
};

vtkStandardNewMacro(VTKErrors::Window);

/** VTK takes memory for all that a file states, before it looks whether that is there. */
void
CheckStatedSizes(const std::string & bytes, const std::string & path)
{
  for (const std::string key : { "NumberOfPoints=",
                                 "NumberOfPolys=",
                                 "NumberOfStrips=",
                                 "NumberOfVerts=",
                                 "NumberOfLines=",
                                 "NumberOfTuples=",
                                 "NumberOfComponents=" })
  {
    for (std::size_t i = bytes.find(key); i != std::string::npos; i = bytes.find(key, i + 1))
    {
      const char * const digits = bytes.data() + i + key.size() + 1; // after the quotation mark
      std::uint64_t      stated = 0;
      const auto         result =
        std::from_chars(std::min(digits, bytes.data() + bytes.size()), bytes.data() + bytes.size(), stated);
      if (result.ec == std::errc::result_out_of_range || stated > BestCompression * bytes.size())
      {
        RefuseSurface(path, key + " states more than the file can hold");
      }
    }
  }
}

SurfaceArray
ArrayOf(vtkDataArray & array, Eigen::Index firstRow, Eigen::Index rows)
{
  SurfaceArray kept{ array.GetName() ? array.GetName() : "",
                     {},
                     array.GetDataType() != VTK_FLOAT && array.GetDataType() != VTK_DOUBLE };
  kept.values.resize(rows, array.GetNumberOfComponents());
  for (Eigen::Index row = 0; row < rows; ++row)
  {
    for (Eigen::Index c = 0; c < kept.values.cols(); ++c)
    {
      kept.values(row, c) = array.GetComponent(firstRow + row, static_cast<int>(c));
    }
  }
  return kept;
}

/** The numerical arrays that have a name and the right number of rows. */
std::vector<SurfaceArray>
ArraysOf(vtkFieldData & data, vtkIdType rows)
{
  std::vector<SurfaceArray> arrays;
  for (int i = 0; i < data.GetNumberOfArrays(); ++i)
  {
    vtkDataArray * const array = data.GetArray(i);
    if (array && array->GetName() && (rows < 0 || array->GetNumberOfTuples() == rows))
    {
      arrays.push_back(ArrayOf(*array, 0, array->GetNumberOfTuples()));
    }
  }
  return arrays;
}

class VtpReader
{
public:
  VtpReader(const std::string & bytes, const std::string & path) : m_Path(path)
  {
    CheckStatedSizes(bytes, path);
    const VTKErrors              errors;
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->ReadFromInputStringOn();
    reader->SetInputString(bytes);
    try
    {
      reader->Update();
    }
    catch (const std::bad_alloc &)
    {
      RefuseSurface(path, "VTK takes too much memory for what it states");
    }
    m_Data = reader->GetOutput();
    if (errors.WereThere() || reader->GetErrorCode() || !m_Data->GetPoints())
    {
      RefuseSurface(path, "no VTP file, truncated, or without points", "copy or write the file again");
    }
  }

  PolygonSurface
  Read()
  {
    for (vtkIdType i = 0; i < m_Data->GetNumberOfPoints(); ++i)
    {
      double p[3];
      m_Data->GetPoint(i, p);
      m_Surface.AddPoint(p[0], p[1], p[2]);
    }
    vtkIdType cell = this->LeaveOut(*m_Data->GetVerts(), "points");
    cell += this->LeaveOut(*m_Data->GetLines(), "lines");
    this->ForEachCell(*m_Data->GetPolys(), [&](const std::vector<std::int64_t> & corners) {
      m_Surface.corners.insert(m_Surface.corners.end(), corners.begin(), corners.end());
      m_Surface.EndPolygon();
      m_Cells.push_back(cell++);
    });
    this->ForEachCell(*m_Data->GetStrips(), [&](const std::vector<std::int64_t> & corners) {
      for (std::size_t i = 2; i < corners.size(); ++i)
      {
        m_Surface.corners.insert(m_Surface.corners.end(),
                                 { corners[i - 2 + i % 2], corners[i - 1 - i % 2], corners[i] });
        m_Surface.EndPolygon();
        m_Cells.push_back(cell);
      }
      ++cell;
    });
    this->ReadArrays(cell);
    return std::move(m_Surface);
  }

private:
  vtkIdType
  LeaveOut(vtkCellArray & cells, const char * what)
  {
    if (cells.GetNumberOfCells() > 0)
    {
      m_Surface.notes.push_back(std::to_string(cells.GetNumberOfCells()) + ' ' + what + " were left out");
    }
    return cells.GetNumberOfCells();
  }

  // VTK does not check what a file says of the ends of its cells.
  template <typename TVisit>
  void
  ForEachCell(vtkCellArray & cells, const TVisit & visit)
  {
    vtkDataArray * const      offsets = cells.GetOffsetsArray();
    vtkDataArray * const      indices = cells.GetConnectivityArray();
    std::vector<std::int64_t> corners;
    for (vtkIdType i = 0; i < cells.GetNumberOfCells(); ++i)
    {
      const double begin = offsets->GetTuple1(i);
      const double end = offsets->GetTuple1(i + 1);
      if (!(begin >= 0.0 && begin <= end && end <= static_cast<double>(indices->GetNumberOfTuples())))
      {
        RefuseSurface(m_Path, "the offset of face " + std::to_string(i) + " is out of range");
      }
      corners.clear();
      for (auto k = static_cast<vtkIdType>(begin); k < static_cast<vtkIdType>(end); ++k)
      {
        corners.push_back(static_cast<std::int64_t>(indices->GetTuple1(k)));
      }
      visit(corners);
    }
  }

  void
  ReadArrays(vtkIdType cells)
  {
    m_Surface.pointArrays = ArraysOf(*m_Data->GetPointData(), m_Data->GetNumberOfPoints());
    for (const SurfaceArray & array : ArraysOf(*m_Data->GetCellData(), cells))
    {
      SurfaceArray kept{ array.name, {}, array.areIntegers };
      kept.values.resize(static_cast<Eigen::Index>(m_Cells.size()), array.values.cols());
      for (std::size_t i = 0; i < m_Cells.size(); ++i)
      {
        kept.values.row(static_cast<Eigen::Index>(i)) = array.values.row(m_Cells[i]);
      }
      m_Surface.cellArrays.push_back(std::move(kept));
    }
    vtkFieldData & field = *m_Data->GetFieldData();
    m_Surface.fieldArrays = ArraysOf(field, -1);
    for (int i = 0; i < field.GetNumberOfArrays(); ++i)
    {
      auto * const strings = vtkStringArray::SafeDownCast(field.GetAbstractArray(i));
      if (!strings || !strings->GetName() || strings->GetNumberOfValues() != 1)
      {
        continue;
      }
      if (strings->GetName() == std::string(SpaceName))
      {
        m_Surface.isRas = strings->GetValue(0).find("RAS") != std::string::npos;
        continue;
      }
      m_Surface.facts.emplace_back(strings->GetName(), strings->GetValue(0));
    }
  }

  std::string                  m_Path;
  vtkSmartPointer<vtkPolyData> m_Data;
  PolygonSurface               m_Surface;
  std::vector<vtkIdType>       m_Cells; ///< the cell of each polygon
};

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
    data.AddArray(array.areIntegers ? Filled<vtkIntArray>(array) : Filled<vtkDoubleArray>(array));
  }
}

void
AddFact(const std::string & name, const std::string & value, vtkFieldData & data)
{
  vtkNew<vtkStringArray> fact;
  fact->SetName(name.c_str());
  fact->InsertNextValue(value);
  data.AddArray(fact);
}

vtkSmartPointer<vtkPolyData>
PolyDataOf(const SurfaceMesh & mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.V.rows());
  for (Eigen::Index v = 0; v < mesh.V.rows(); ++v)
  {
    points->SetPoint(v, mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2));
  }
  vtkNew<vtkCellArray> faces;
  for (Eigen::Index f = 0; f < mesh.F.rows(); ++f)
  {
    const vtkIdType corners[] = { mesh.F(f, 0), mesh.F(f, 1), mesh.F(f, 2) };
    faces->InsertNextCell(3, corners);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(faces);
  AddArrays(mesh.pointArrays, *data->GetPointData());
  AddArrays(mesh.cellArrays, *data->GetCellData());
  AddArrays(mesh.fieldArrays, *data->GetFieldData());
  AddFact(SpaceName, "LPS", *data->GetFieldData());
  for (const auto & [name, value] : mesh.facts)
  {
    AddFact(name, value, *data->GetFieldData());
  }
  return data;
}
} // namespace

PolygonSurface
ReadVtp(const std::string & bytes, const std::string & path)
{
  return VtpReader(bytes, path).Read();
}

void
WriteVtp(const SurfaceMesh & mesh, const std::string & path)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(PolyDataOf(mesh));
  writer->WriteToOutputStringOn();
  writer->SetHeaderTypeToUInt64();
  writer->Write();
  WriteFileBytes(path, writer->GetOutputString());
}
} // namespace itk
