#include "shapetonBinaryValues.h"
#include "shapetonFileBytes.h"
#include "shapetonPrintable.h"
#include "shapetonSurfaceFormats.h"
#include "shapetonTextScanner.h"
#include "shapetonTriangleShape.h"

namespace shapeton
{
namespace
{
constexpr std::size_t HeaderSize = 80;                // bytes of a binary file
constexpr std::size_t FirstTriangle = HeaderSize + 4; // after the number of triangles, 4 bytes
constexpr std::size_t TriangleSize = 50;              // bytes: normal, three corners, attribute

bool
SaysRas(const std::string & header)
{
  return header.find("SPACE=RAS") != std::string::npos;
}

void
AddTriangleOfLast(PolygonSurface & surface)
{
  const auto next = static_cast<std::int64_t>(surface.points.size() / 3);
  surface.corners.insert(surface.corners.end(), { next - 3, next - 2, next - 1 });
  surface.EndPolygon();
}

PolygonSurface
ReadBinary(const std::string & bytes, const std::string & path)
{
  const std::size_t stated = ValueAt<std::uint32_t>(bytes, HeaderSize);
  const std::size_t held = (bytes.size() - FirstTriangle) / TriangleSize;
  if (stated > held)
  {
    RefuseSurface(path,
                  "truncated, or not an STL file: it states " + std::to_string(stated) +
                    " triangles but has space for " + std::to_string(held),
                  "copy or write the file again");
  }
  PolygonSurface surface;
  surface.repeatsVertices = true;
  surface.isRas = SaysRas(bytes.substr(0, HeaderSize));
  surface.points.reserve(9 * stated);
  for (std::size_t t = 0; t < stated; ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const std::size_t offset = FirstTriangle + t * TriangleSize + 12 * (i + 1); // skips the normal
      surface.AddPoint(
        ValueAt<float>(bytes, offset), ValueAt<float>(bytes, offset + 4), ValueAt<float>(bytes, offset + 8));
    }
    AddTriangleOfLast(surface);
  }
  if (bytes.size() != FirstTriangle + stated * TriangleSize)
  {
    surface.notes.push_back("bytes after the last triangle were ignored");
  }
  return surface;
}

void
Expect(TextScanner & scanner, const std::string & word)
{
  const std::string found(scanner.Word());
  if (LowerCase(found) != word) // some programs write keywords in capitals
  {
    scanner.Refuse(found.empty() ? "truncated: the file ends where \"" + word + "\" should be"
                                 : "\"" + found.substr(0, LongestExcerpt) + "\" found instead of \"" + word + "\"");
  }
}

void
ReadFacet(TextScanner & scanner, PolygonSurface & surface)
{
  Expect(scanner, "normal");
  for (int i = 0; i < 3; ++i)
  {
    scanner.Word(); // any text: some programs write "nan"
  }
  Expect(scanner, "outer");
  Expect(scanner, "loop");
  for (int i = 0; i < 3; ++i)
  {
    Expect(scanner, "vertex");
    const double x = scanner.Number("a coordinate", true);
    const double y = scanner.Number("a coordinate", true);
    surface.AddPoint(x, y, scanner.Number("a coordinate", true));
  }
  Expect(scanner, "endloop");
  Expect(scanner, "endfacet");
  AddTriangleOfLast(surface);
}

PolygonSurface
ReadText(const std::string & bytes, const std::string & path)
{
  PolygonSurface surface;
  surface.repeatsVertices = true;
  surface.isRas = SaysRas(bytes.substr(0, bytes.find('\n')));
  TextScanner scanner(bytes, path);
  bool        isInside = true; // in a solid: its first line is skipped with its name
  while (scanner.NextLine())
  {
    const std::string word(scanner.WordOfLine());
    const std::string keyword = LowerCase(word);
    if (isInside && keyword == "facet")
    {
      ReadFacet(scanner, surface);
    }
    else if (keyword == (isInside ? "endsolid" : "solid"))
    {
      isInside = !isInside;
    }
    else
    {
      scanner.Refuse("\"" + word.substr(0, LongestExcerpt) + "\" found instead of \"" + (isInside ? "facet" : "solid") +
                     "\"");
    }
  }
  if (isInside)
  {
    scanner.Refuse("truncated: the file ends without \"endsolid\"");
  }
  return surface;
}
} // namespace

PolygonSurface
ReadStl(const std::string & bytes, const std::string & path)
{
  const bool isLongEnough = bytes.size() >= FirstTriangle;
  const bool hasStatedSize =
    isLongEnough &&
    bytes.size() == FirstTriangle + TriangleSize * std::size_t{ ValueAt<std::uint32_t>(bytes, HeaderSize) };
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  const bool        saysSolid = begin != std::string::npos && LowerCase(bytes.substr(begin, 5)) == "solid";
  const bool        isText = saysSolid && bytes.find('\0') == std::string::npos; // binary files may start with "solid"
  if (isLongEnough && (hasStatedSize || !isText))
  {
    return ReadBinary(bytes, path);
  }
  if (!isText)
  {
    RefuseSurface(path, "neither a text nor a binary STL file", "use a surface file");
  }
  return ReadText(bytes, path);
}

void
WriteStl(const SurfaceMesh & mesh, const std::string & path)
{
  std::string bytes = "Shapeton surface, mm, SPACE=LPS";
  bytes.resize(HeaderSize, ' ');
  AppendValue(bytes, static_cast<std::uint32_t>(mesh.F.rows()));
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const Eigen::Vector3d corners[] = { mesh.V.row(mesh.F(f, 0)), mesh.V.row(mesh.F(f, 1)), mesh.V.row(mesh.F(f, 2)) };
    const Eigen::Vector3d normal = DoubleAreaNormal(corners[0], corners[1], corners[2]).stableNormalized();
    for (const Eigen::Vector3d & vector : { normal, corners[0], corners[1], corners[2] })
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        AppendValue(bytes, static_cast<float>(vector[axis]));
      }
    }
    AppendValue(bytes, std::uint16_t{ 0 });
  }
  WriteFileBytes(path, bytes);
}
} // namespace shapeton
