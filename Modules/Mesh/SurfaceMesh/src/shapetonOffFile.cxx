#include "shapetonSurfaceFormats.h"
#include "shapetonTextScanner.h"

namespace shapeton
{
namespace
{
/** Reads the keyword; the rest of its line may already contain the counts. */
void
ReadKeyword(TextScanner & scanner)
{
  const std::string keyword(scanner.Word());
  const std::size_t end = keyword.size() < 3 ? 0 : keyword.size() - 3;
  if (keyword.size() < 3 || keyword.substr(end) != "OFF" || keyword.size() > 10)
  {
    scanner.Refuse("the file does not begin with OFF");
  }
  if (keyword.find('4') != std::string::npos || keyword.find('n') != std::string::npos)
  {
    scanner.Refuse("vertices of four or more dimensions (" + keyword + ") are not supported");
  }
}

std::size_t
ReadCount(TextScanner & scanner, const char * what, std::size_t limit)
{
  const std::int64_t count = scanner.Integer(what, true);
  if (count < 0 || static_cast<std::uint64_t>(count) > limit)
  {
    scanner.Refuse(std::to_string(count) + " as " + what + " is more than the file can contain");
  }
  return static_cast<std::size_t>(count);
}

void
NextLine(TextScanner & scanner, const std::string & what, std::size_t index, std::size_t count)
{
  if (!scanner.NextLine())
  {
    scanner.Refuse("the file ends at " + what + ' ' + std::to_string(index) + " of " + std::to_string(count));
  }
}
} // namespace

// http://www.geomview.org/docs/html/OFF.html; colors, normals and texture coordinates follow the position or the
// indices on their line and are ignored.
PolygonSurface
ReadOff(const std::string & bytes, const std::string & path)
{
  TextScanner scanner(bytes, path, '#');
  ReadKeyword(scanner);
  const std::size_t vertices = ReadCount(scanner, "the number of vertices", bytes.size() / 6);
  const std::size_t faces = ReadCount(scanner, "the number of faces", bytes.size() / 6);
  PolygonSurface    surface;
  for (std::size_t v = 0; v < vertices; ++v)
  {
    NextLine(scanner, "vertex", v, vertices);
    const double x = scanner.Number("a coordinate");
    const double y = scanner.Number("a coordinate");
    surface.AddPoint(x, y, scanner.Number("a coordinate"));
  }
  for (std::size_t f = 0; f < faces; ++f)
  {
    NextLine(scanner, "face", f, faces);
    const std::int64_t corners = scanner.Integer("the number of corners");
    for (std::int64_t i = 0; i < corners; ++i)
    {
      surface.corners.push_back(scanner.Integer("the index of a vertex"));
    }
    surface.EndPolygon();
  }
  return surface;
}
} // namespace shapeton
