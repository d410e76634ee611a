#include "shapetonSurfaceFormats.h"
#include "shapetonVtkXml.h"

#include <algorithm>

namespace shapeton
{
namespace
{
enum class VtpCells
{
  Faces,
  Curves
};

class VtpReader
{
public:
  VtpReader(const std::string & bytes, const std::string & path, VtpCells wanted) : m_Xml(bytes, path), m_Wanted(wanted)
  {}

  PolygonSurface
  Read()
  {
    const VtkXmlElement * const data = m_Xml.Root().Find("PolyData");
    if (m_Xml.Root().name != "VTKFile" || !data)
    {
      m_Xml.Refuse("not a VTP file: it lacks <VTKFile> or <PolyData>");
    }
    for (const VtkXmlElement & child : data->children)
    {
      if (child.name == "Piece")
      {
        this->ReadPiece(child);
      }
      else if (child.name == "FieldData")
      {
        this->ReadFieldData(child);
      }
    }
    KeepWhole(m_PointArrays, m_Surface.points.size() / 3, m_Surface.pointArrays);
    KeepWhole(m_CellArrays, m_Surface.ends.size(), m_Surface.cellArrays);
    if (m_LeftOut)
    {
      m_Surface.notes.push_back(std::to_string(m_LeftOut) + (m_Wanted == VtpCells::Faces
                                                               ? " points and lines were skipped"
                                                               : " faces were skipped"));
    }
    return std::move(m_Surface);
  }

private:
  /** Concatenates the rows of the pieces; keeps arrays that exist in all pieces. */
  struct Gathered
  {
    SurfaceArray        array;
    std::size_t         components{ 1 };
    std::vector<double> values;
  };

  static void
  KeepWhole(std::vector<Gathered> & gathered, std::size_t rows, std::vector<SurfaceArray> & kept)
  {
    for (Gathered & one : gathered)
    {
      if (one.values.size() == rows * one.components)
      {
        one.array.values = Eigen::Map<const SurfaceArray::ValueMatrix>(
          one.values.data(), static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(one.components));
        kept.push_back(std::move(one.array));
      }
    }
  }

  std::size_t
  ComponentsOf(const VtkXmlElement & array) const
  {
    return array.Get("NumberOfComponents").empty()
             ? 1
             : std::max<std::size_t>(m_Xml.Number(array, "NumberOfComponents"), 1);
  }

  std::vector<double>
  ValuesOf(const VtkXmlElement * parent, const std::string & name, std::size_t wanted) const
  {
    for (std::size_t i = 0; parent && i < parent->children.size(); ++i)
    {
      const VtkXmlElement & array = parent->children[i];
      if (array.name == "DataArray" && (name.empty() || array.Get("Name") == name))
      {
        std::vector<double> values = m_Xml.Values(array);
        if (values.size() != wanted && wanted > 0)
        {
          m_Xml.Refuse("an array of <" + parent->name + "> has " + std::to_string(values.size()) + " values for " +
                       std::to_string(wanted));
        }
        return values;
      }
    }
    if (wanted > 0)
    {
      m_Xml.Refuse("its points or the arrays of its faces are missing");
    }
    return {};
  }

  std::size_t
  CountOf(const VtkXmlElement & piece, const std::string & attribute) const
  {
    return piece.Get(attribute).empty() ? 0 : m_Xml.Number(piece, attribute);
  }

  void
  ReadPiece(const VtkXmlElement & piece)
  {
    const auto                firstPoint = static_cast<std::int64_t>(m_Surface.points.size() / 3);
    const std::size_t         points = this->CountOf(piece, "NumberOfPoints");
    const std::vector<double> positions = this->ValuesOf(piece.Find("Points"), "", 3 * points);
    m_Surface.points.insert(m_Surface.points.end(), positions.begin(), positions.begin() + 3 * points);
    this->Gather(piece.Find("PointData"), 0, points, points, m_PointArrays);
    const std::size_t verts = this->CountOf(piece, "NumberOfVerts");
    const std::size_t lines = this->CountOf(piece, "NumberOfLines");
    const std::size_t polys = this->CountOf(piece, "NumberOfPolys");
    const std::size_t strips = this->CountOf(piece, "NumberOfStrips");
    if (m_Wanted == VtpCells::Curves)
    {
      m_LeftOut += polys + strips;
      this->ReadCells(piece.Find("Verts"), verts, firstPoint, points, false);
      this->ReadCells(piece.Find("Lines"), lines, firstPoint, points, false);
      this->Gather(piece.Find("CellData"), 0, verts + lines, verts + lines + polys + strips, m_CellArrays);
      return;
    }
    m_LeftOut += verts + lines;
    this->ReadCells(piece.Find("Polys"), polys, firstPoint, points, false);
    this->ReadCells(piece.Find("Strips"), strips, firstPoint, points, true);
    if (strips == 0) // cell arrays have one row per strip, not per triangle
    {
      this->Gather(piece.Find("CellData"), verts + lines, polys, verts + lines + polys, m_CellArrays);
    }
  }

  void
  ReadCells(const VtkXmlElement * cells, std::size_t count, std::int64_t firstPoint, std::size_t points, bool areStrips)
  {
    if (count == 0)
    {
      return;
    }
    const std::vector<double> offsets = this->ValuesOf(cells, "offsets", count);
    const std::vector<double> connectivity = this->ValuesOf(cells, "connectivity", 0);
    std::vector<std::int64_t> corners;
    double                    begin = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!(offsets[i] >= begin && offsets[i] <= static_cast<double>(connectivity.size())))
      {
        m_Xml.Refuse("the offset of face " + std::to_string(i) + " is out of range");
      }
      corners.clear();
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(offsets[i]); ++k)
      {
        if (!(connectivity[k] >= 0.0 && connectivity[k] < static_cast<double>(points)))
        {
          m_Xml.Refuse("face " + std::to_string(i) + " refers to a vertex outside the " + std::to_string(points));
        }
        corners.push_back(firstPoint + static_cast<std::int64_t>(connectivity[k]));
      }
      begin = offsets[i];
      this->AddCell(corners, areStrips);
    }
  }

  void
  AddCell(const std::vector<std::int64_t> & corners, bool isStrip)
  {
    if (!isStrip)
    {
      m_Surface.corners.insert(m_Surface.corners.end(), corners.begin(), corners.end());
      m_Surface.EndPolygon();
      return;
    }
    for (std::size_t i = 2; i < corners.size(); ++i) // every other triangle of a strip is reversed
    {
      m_Surface.corners.insert(m_Surface.corners.end(), { corners[i - 2 + i % 2], corners[i - 1 - i % 2], corners[i] });
      m_Surface.EndPolygon();
    }
  }

  /** Appends `rows` rows, starting at `first`, of each numeric array with `all` rows. */
  void
  Gather(const VtkXmlElement *   parent,
         std::size_t             first,
         std::size_t             rows,
         std::size_t             all,
         std::vector<Gathered> & gathered) const
  {
    for (std::size_t i = 0; parent && i < parent->children.size(); ++i)
    {
      const VtkXmlElement & array = parent->children[i];
      if (array.name != "DataArray")
      {
        continue;
      }
      const std::size_t         components = this->ComponentsOf(array);
      const std::vector<double> values = m_Xml.Values(array);
      auto                      place = std::find_if(gathered.begin(), gathered.end(), [&](const Gathered & one) {
        return one.array.name == array.Get("Name") && one.components == components;
      });
      if (place == gathered.end())
      {
        gathered.push_back({ { array.Get("Name"), {}, VtkXml::AreIntegers(array) }, components, {} });
        place = gathered.end() - 1;
      }
      if (values.size() == all * components)
      {
        const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first * components);
        place->values.insert(place->values.end(), begin, begin + static_cast<std::ptrdiff_t>(rows * components));
      }
    }
  }

  void
  ReadFieldData(const VtkXmlElement & field)
  {
    for (const VtkXmlElement & array : field.children)
    {
      const std::string name = array.Get("Name");
      if (array.name == "DataArray")
      {
        const std::size_t         components = this->ComponentsOf(array);
        const std::vector<double> values = m_Xml.Values(array);
        SurfaceArray              kept{ name, {}, VtkXml::AreIntegers(array) };
        kept.values = Eigen::Map<const SurfaceArray::ValueMatrix>(
          values.data(), static_cast<Eigen::Index>(values.size() / components), static_cast<Eigen::Index>(components));
        m_Surface.fieldArrays.push_back(std::move(kept));
        continue;
      }
      const std::vector<std::string> strings = m_Xml.Strings(array);
      if (name == VtpSpaceName)
      {
        m_Surface.isRas = !strings.empty() && strings[0].find("RAS") != std::string::npos;
      }
      else if (strings.size() == 1)
      {
        m_Surface.facts.emplace_back(name, strings[0]);
      }
    }
  }

  VtkXml                m_Xml;
  VtpCells              m_Wanted;
  PolygonSurface        m_Surface;
  std::vector<Gathered> m_PointArrays;
  std::vector<Gathered> m_CellArrays;
  std::size_t           m_LeftOut{ 0 };
};
} // namespace

PolygonSurface
ReadVtp(const std::string & bytes, const std::string & path)
{
  return VtpReader(bytes, path, VtpCells::Faces).Read();
}

PolygonSurface
ReadVtpCurves(const std::string & bytes, const std::string & path)
{
  return VtpReader(bytes, path, VtpCells::Curves).Read();
}
} // namespace shapeton
