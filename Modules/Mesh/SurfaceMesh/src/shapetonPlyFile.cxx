#include "shapetonBinaryValues.h"
#include "shapetonPrintable.h"
#include "shapetonFileBytes.h"
#include "shapetonSurfaceFormats.h"
#include "shapetonTextScanner.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace shapeton
{
namespace
{
struct PlyProperty
{
  std::string name;
  BinaryType  type{ BinaryTypeOf<float>() };
  bool        isList{ false };
  BinaryType  countType{ BinaryTypeOf<std::uint8_t>() };
};

struct PlyElement
{
  std::string              name;
  std::size_t              count{ 0 };
  std::vector<PlyProperty> properties;
};

const BinaryType &
TypeOf(const std::string & name, const TextScanner & scanner)
{
  static const std::map<std::string, BinaryType> types{
    { "char", BinaryTypeOf<std::int8_t>() },     { "int8", BinaryTypeOf<std::int8_t>() },
    { "uchar", BinaryTypeOf<std::uint8_t>() },   { "uint8", BinaryTypeOf<std::uint8_t>() },
    { "short", BinaryTypeOf<std::int16_t>() },   { "int16", BinaryTypeOf<std::int16_t>() },
    { "ushort", BinaryTypeOf<std::uint16_t>() }, { "uint16", BinaryTypeOf<std::uint16_t>() },
    { "int", BinaryTypeOf<std::int32_t>() },     { "int32", BinaryTypeOf<std::int32_t>() },
    { "uint", BinaryTypeOf<std::uint32_t>() },   { "uint32", BinaryTypeOf<std::uint32_t>() },
    { "float", BinaryTypeOf<float>() },          { "float32", BinaryTypeOf<float>() },
    { "double", BinaryTypeOf<double>() },        { "float64", BinaryTypeOf<double>() }
  };
  const auto found = types.find(name);
  if (found == types.end())
  {
    scanner.Refuse("\"" + name.substr(0, LongestExcerpt) + "\" is not a property type");
  }
  return found->second;
}

/** Sequential values, from text or bytes. */
class PlyValues
{
public:
  PlyValues(const std::string & bytes,
            const std::string & path,
            const std::string & format,
            std::size_t         begin,
            int                 line)
    : m_Bytes(bytes)
    , m_Path(path)
    , m_IsText(format == "ascii")
    , m_IsBigEndian(format == "binary_big_endian")
    , m_Place(begin)
    , m_Scanner(bytes, path, 0, begin, line)
  {}

  double
  Next(const BinaryType & type)
  {
    if (m_IsText)
    {
      return m_Scanner.Number("a value", true);
    }
    if (m_Bytes.size() - m_Place < type.size)
    {
      RefuseSurface(m_Path, "truncated: its data end before the last element", "copy or write the file again");
    }
    m_Place += type.size;
    return type.valueAt(m_Bytes, m_Place - type.size, m_IsBigEndian);
  }

  /** An integer from -2^31 to 2^32 - 1. */
  std::int64_t
  NextWhole(const BinaryType & type)
  {
    const double     value = this->Next(type);
    constexpr double greatest = 4294967295.0; // of 32 bits
    if (!(std::abs(value) <= greatest) || value != std::floor(value))
    {
      RefuseSurface(m_Path, "a count or index is not an integer", "correct the file");
    }
    return static_cast<std::int64_t>(value);
  }

private:
  const std::string & m_Bytes;
  const std::string & m_Path;
  bool                m_IsText;
  bool                m_IsBigEndian;
  std::size_t         m_Place;
  TextScanner         m_Scanner;
};

class PlyReader
{
public:
  PlyReader(const std::string & bytes, const std::string & path) : m_Bytes(bytes), m_Path(path) {}

  PolygonSurface
  Read()
  {
    this->ReadHeader();
    PlyValues values(m_Bytes, m_Path, m_Format, m_DataBegin, m_DataLine);
    for (const PlyElement & element : m_Elements)
    {
      this->ReadElement(element, values);
    }
    return std::move(m_Surface);
  }

private:
  void
  ReadHeader()
  {
    const std::size_t end = m_Bytes.find("end_header");
    if (m_Bytes.compare(0, 3, "ply") != 0 || end == std::string::npos)
    {
      RefuseSurface(m_Path, "not a PLY file: it lacks \"ply\" or \"end_header\"", "use a surface file");
    }
    const std::string header = m_Bytes.substr(0, end);
    m_DataBegin = std::min(m_Bytes.find('\n', end), m_Bytes.size() - 1) + 1;
    m_DataLine = 1 + static_cast<int>(std::count(m_Bytes.begin(), m_Bytes.begin() + m_DataBegin, '\n'));
    TextScanner scanner(header, m_Path);
    while (scanner.NextLine())
    {
      this->ReadHeaderLine(scanner);
    }
    if (m_Format != "ascii" && m_Format != "binary_little_endian" && m_Format != "binary_big_endian")
    {
      RefuseSurface(m_Path, "the format \"" + m_Format.substr(0, LongestExcerpt) + "\" is unknown");
    }
  }

  void
  ReadHeaderLine(TextScanner & scanner)
  {
    const std::string keyword(scanner.WordOfLine());
    if (keyword == "format")
    {
      m_Format = scanner.WordOfLine();
    }
    else if (keyword == "comment" || keyword == "obj_info")
    {
      for (std::string_view word = scanner.WordOfLine(); !word.empty(); word = scanner.WordOfLine())
      {
        m_Surface.isRas = m_Surface.isRas || word.find("SPACE=RAS") != std::string_view::npos;
      }
    }
    else if (keyword == "element")
    {
      PlyElement element;
      element.name = scanner.WordOfLine();
      const std::int64_t count = scanner.Integer("the number of elements");
      if (count < 0 || static_cast<std::uint64_t>(count) > m_Bytes.size())
      {
        scanner.Refuse(std::to_string(count) + " elements are more than the file can contain");
      }
      element.count = static_cast<std::size_t>(count);
      m_Elements.push_back(element);
    }
    else if (keyword == "property")
    {
      this->ReadProperty(scanner);
    }
    else
    {
      scanner.Refuse("\"" + keyword.substr(0, LongestExcerpt) + "\" is not a PLY header keyword");
    }
  }

  void
  ReadProperty(TextScanner & scanner)
  {
    PlyProperty property;
    std::string type(scanner.WordOfLine());
    property.isList = type == "list";
    if (property.isList)
    {
      property.countType = TypeOf(std::string(scanner.WordOfLine()), scanner);
      type = scanner.WordOfLine();
    }
    property.type = TypeOf(type, scanner);
    property.name = scanner.WordOfLine();
    if (m_Elements.empty() || property.name.empty())
    {
      scanner.Refuse("a property without a name or an element");
    }
    m_Elements.back().properties.push_back(property);
  }

  void
  ReadElement(const PlyElement & element, PlyValues & values)
  {
    const bool                isVertex = element.name == "vertex";
    const bool                isFace = element.name == "face";
    std::vector<SurfaceArray> arrays;
    for (const PlyProperty & property : element.properties)
    {
      arrays.push_back({ property.name, {}, property.type.isInteger });
      arrays.back().values.resize(property.isList ? 0 : static_cast<Eigen::Index>(element.count), 1);
    }
    for (std::size_t i = 0; i < element.count; ++i)
    {
      for (std::size_t k = 0; k < arrays.size(); ++k)
      {
        const PlyProperty & property = element.properties[k];
        if (property.isList)
        {
          this->ReadList(property, isFace && this->IsCorners(property), values);
        }
        else
        {
          arrays[k].values(static_cast<Eigen::Index>(i), 0) = values.Next(property.type);
        }
      }
      if (isFace)
      {
        m_Surface.EndPolygon();
      }
    }
    if (isVertex)
    {
      this->TakePositions(arrays);
    }
    if (element.name == "tristrips")
    {
      RefuseSurface(m_Path, "triangle strips of PLY are not supported", "write the file with faces");
    }
    this->KeepArrays(element, arrays, isVertex ? &m_Surface.pointArrays : isFace ? &m_Surface.cellArrays : nullptr);
  }

  static bool
  IsCorners(const PlyProperty & property)
  {
    return property.name == "vertex_indices" || property.name == "vertex_index";
  }

  void
  ReadList(const PlyProperty & property, bool isCorners, PlyValues & values)
  {
    const std::int64_t count = values.NextWhole(property.countType);
    for (std::int64_t i = 0; i < count; ++i)
    {
      if (isCorners)
      {
        m_Surface.corners.push_back(values.NextWhole(property.type));
      }
      else
      {
        values.Next(property.type);
      }
    }
  }

  void
  TakePositions(std::vector<SurfaceArray> & arrays)
  {
    const SurfaceArray * axes[] = { FindSurfaceArray(arrays, "x"),
                                    FindSurfaceArray(arrays, "y"),
                                    FindSurfaceArray(arrays, "z") };
    if (!axes[0] || !axes[1] || !axes[2])
    {
      RefuseSurface(m_Path, "the vertices lack x, y or z");
    }
    for (Eigen::Index i = 0; i < axes[0]->values.rows(); ++i)
    {
      m_Surface.AddPoint(axes[0]->values(i), axes[1]->values(i), axes[2]->values(i));
    }
  }

  static void
  KeepArrays(const PlyElement & element, std::vector<SurfaceArray> & arrays, std::vector<SurfaceArray> * kept)
  {
    for (std::size_t k = 0; kept && k < arrays.size(); ++k)
    {
      const std::string & name = arrays[k].name;
      const bool          isPosition = element.name == "vertex" && (name == "x" || name == "y" || name == "z");
      if (!element.properties[k].isList && !isPosition)
      {
        kept->push_back(std::move(arrays[k]));
      }
    }
  }

  const std::string &     m_Bytes;
  const std::string &     m_Path;
  std::string             m_Format;
  std::vector<PlyElement> m_Elements;
  std::size_t             m_DataBegin{ 0 };
  int                     m_DataLine{ 1 };
  PolygonSurface          m_Surface;
};

std::vector<const SurfaceArray *>
ArraysOfPly(const std::vector<SurfaceArray> & arrays)
{
  std::vector<const SurfaceArray *> fitting;
  for (const SurfaceArray & array : arrays)
  {
    if (array.values.cols() == 1 && !array.name.empty() && array.name.find_first_of(" \t\r\n") == std::string::npos)
    {
      fitting.push_back(&array);
    }
  }
  return fitting;
}

std::string
HeaderOf(const std::vector<const SurfaceArray *> & arrays)
{
  std::string text;
  for (const SurfaceArray * array : arrays)
  {
    text += std::string("property ") + (array->areIntegers ? "int " : "double ") + array->name + '\n';
  }
  return text;
}

void
AppendRow(const std::vector<const SurfaceArray *> & arrays, int row, std::string & bytes)
{
  for (const SurfaceArray * array : arrays)
  {
    if (array->areIntegers)
    {
      AppendValue(bytes, static_cast<std::int32_t>(array->values(row, 0)));
    }
    else
    {
      AppendValue(bytes, array->values(row, 0));
    }
  }
}
} // namespace

PolygonSurface
ReadPly(const std::string & bytes, const std::string & path)
{
  return PlyReader(bytes, path).Read();
}

void
WritePly(const SurfaceMesh & mesh, const std::string & path)
{
  const auto  pointArrays = ArraysOfPly(mesh.pointArrays);
  const auto  cellArrays = ArraysOfPly(mesh.cellArrays);
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment Shapeton surface, mm, SPACE=LPS\n";
  bytes += "element vertex " + std::to_string(mesh.V.rows()) + '\n';
  bytes += "property double x\nproperty double y\nproperty double z\n" + HeaderOf(pointArrays);
  bytes += "element face " + std::to_string(mesh.F.rows()) + '\n';
  bytes += "property list uchar int vertex_indices\n" + HeaderOf(cellArrays) + "end_header\n";
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      AppendValue(bytes, mesh.V(v, axis));
    }
    AppendRow(pointArrays, v, bytes);
  }
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    AppendValue(bytes, std::uint8_t{ 3 });
    for (int k = 0; k < 3; ++k)
    {
      AppendValue(bytes, static_cast<std::int32_t>(mesh.F(f, k)));
    }
    AppendRow(cellArrays, f, bytes);
  }
  WriteFileBytes(path, bytes);
}
} // namespace shapeton
