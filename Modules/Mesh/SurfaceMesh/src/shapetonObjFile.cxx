#include "shapetonCsvTable.h"
#include "shapetonPrintable.h"
#include "shapetonFileBytes.h"
#include "shapetonSurfaceFormats.h"
#include "shapetonTextScanner.h"

#include <charconv>

namespace shapeton
{
namespace
{
class ObjReader
{
public:
  ObjReader(const std::string & bytes, const std::string & path)
    : m_Text('\n' + bytes), m_Scanner(m_Text, path, '#', 0, 0, '\\')
  {
    for (std::size_t i = m_Text.find("SPACE=RAS"); i != std::string::npos; i = m_Text.find("SPACE=RAS", i + 1))
    {
      m_Surface.isRas = m_Surface.isRas || m_Text[m_Text.rfind('\n', i) + 1] == '#';
    }
  }

  PolygonSurface
  Read()
  {
    while (m_Scanner.NextLine())
    {
      const std::string_view keyword = m_Scanner.WordOfLine();
      if (keyword == "v")
      {
        const double x = m_Scanner.Number("a coordinate");
        const double y = m_Scanner.Number("a coordinate");
        m_Surface.AddPoint(x, y, m_Scanner.Number("a coordinate"));
      }
      else if (keyword == "f" || keyword == "fo")
      {
        this->ReadFace();
      }
      else if (keyword == "o" || keyword == "g")
      {
        this->BeginPart();
      }
      else
      {
        m_LeftOut += keyword == "l" || keyword == "p" || keyword == "curv" || keyword == "surf";
      }
    }
    this->EndPart();
    if (m_LeftOut)
    {
      m_Surface.notes.push_back(std::to_string(m_LeftOut) + " points, lines or curves were skipped");
    }
    return std::move(m_Surface);
  }

private:
  // "7", "7/1", "7//3", "7/1/3"; counted from 1; negative indices are relative to the last vertex.
  void
  ReadFace()
  {
    const auto vertices = static_cast<std::int64_t>(m_Surface.points.size() / 3);
    for (std::string_view word = m_Scanner.WordOfLine(); !word.empty(); word = m_Scanner.WordOfLine())
    {
      std::int64_t index = 0;
      const auto   result = std::from_chars(word.data(), word.data() + word.size(), index);
      const bool   isWhole = result.ptr == word.data() + word.size() || *result.ptr == '/';
      if (result.ec != std::errc() || !isWhole || index == 0)
      {
        m_Scanner.Refuse("\"" + std::string(word.substr(0, LongestExcerpt)) + "\" is not a vertex index (from 1)");
      }
      m_Surface.corners.push_back(index > 0 ? index - 1 : vertices + index);
      if (m_Surface.corners.back() < 0)
      {
        m_Scanner.Refuse("the index " + std::to_string(index) + " points before the first vertex");
      }
    }
    m_Surface.EndPolygon();
  }

  void
  BeginPart()
  {
    this->EndPart();
    std::string name;
    for (std::string_view word = m_Scanner.WordOfLine(); !word.empty(); word = m_Scanner.WordOfLine())
    {
      name += (name.empty() ? "" : " ") + std::string(word);
    }
    m_Surface.parts.push_back({ name, static_cast<int>(m_Surface.ends.size()), 0 });
  }

  void
  EndPart()
  {
    if (!m_Surface.parts.empty())
    {
      SurfacePart & part = m_Surface.parts.back();
      part.numberOfFaces = static_cast<int>(m_Surface.ends.size()) - part.firstFace;
      if (part.numberOfFaces == 0)
      {
        m_Surface.parts.pop_back();
      }
    }
  }

  std::string    m_Text; // starts with an empty line, because NextLine() advances first
  TextScanner    m_Scanner;
  PolygonSurface m_Surface;
  int            m_LeftOut{ 0 };
};
} // namespace

PolygonSurface
ReadObj(const std::string & bytes, const std::string & path)
{
  return ObjReader(bytes, path).Read();
}

void
WriteObj(const SurfaceMesh & mesh, const std::string & path)
{
  std::string text = "# Shapeton surface, mm, SPACE=LPS\n";
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    text += "v " + CsvTable::Number(mesh.V(v, 0)) + ' ' + CsvTable::Number(mesh.V(v, 1)) + ' ' +
            CsvTable::Number(mesh.V(v, 2)) + '\n';
  }
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    text += "f " + std::to_string(mesh.F(f, 0) + 1) + ' ' + std::to_string(mesh.F(f, 1) + 1) + ' ' +
            std::to_string(mesh.F(f, 2) + 1) + '\n';
  }
  WriteFileBytes(path, text);
}
} // namespace shapeton
