#include "shapetonFileBytes.h"
#include "shapetonPolygonTriangulation.h"
#include "shapetonSurfaceFormats.h"
#include "shapetonExceptions.h"
#include "shapetonPrintable.h"
#include "shapetonVertexMerging.h"

#include <climits>
#include <filesystem>
#include <map>

namespace shapeton
{
namespace
{
constexpr std::size_t MostCornersToSearchEars = 1000; // ear search is cubic in the corners

void
CheckPolygons(const PolygonSurface & polygons, const std::string & path)
{
  const auto vertices = static_cast<std::int64_t>(polygons.points.size() / 3);
  if (vertices > INT_MAX / 4 || polygons.corners.size() > INT_MAX / 4)
  {
    RefuseSurface(path, "there are more vertices or corners than 500 million", "cut or simplify the surface");
  }
  std::size_t begin = 0;
  for (std::size_t p = 0; p < polygons.ends.size(); ++p)
  {
    if (polygons.ends[p] < begin + 3)
    {
      RefuseSurface(path,
                    "face " + std::to_string(p) + " has " + std::to_string(polygons.ends[p] - begin) +
                      " corners, fewer than three");
    }
    for (; begin < polygons.ends[p]; ++begin)
    {
      if (polygons.corners[begin] < 0 || polygons.corners[begin] >= vertices)
      {
        RefuseSurface(path,
                      "face " + std::to_string(p) + " refers to vertex " + std::to_string(polygons.corners[begin]) +
                        " (counted from 0), but there are " + std::to_string(vertices));
      }
    }
  }
}

/** Triangles of polygons; `polygonOf` receives the polygon of each. */
std::vector<int>
TrianglesOf(const PolygonSurface & polygons, std::vector<int> & polygonOf)
{
  std::vector<int>             triangles;
  std::vector<Eigen::Vector3d> corners;
  std::size_t                  begin = 0;
  for (std::size_t p = 0; p < polygons.ends.size(); ++p)
  {
    const std::size_t end = polygons.ends[p];
    corners.clear();
    for (std::size_t i = begin; i < end && end - begin > 3 && end - begin <= MostCornersToSearchEars; ++i)
    {
      const double * const point = &polygons.points[3 * polygons.corners[i]];
      corners.emplace_back(point[0], point[1], point[2]);
    }
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      for (const std::size_t corner : { a, b, c })
      {
        triangles.push_back(static_cast<int>(polygons.corners[begin + corner]));
      }
      polygonOf.push_back(static_cast<int>(p));
    };
    for (const auto & t : TriangulatePolygon(corners))
    {
      add(t[0], t[1], t[2]);
    }
    for (std::size_t i = 2; corners.empty() && begin + i < end; ++i) // a triangle, or a fan of very many corners
    {
      add(0, i - 1, i);
    }
    begin = end;
  }
  return triangles;
}

void
NamePartsApart(std::vector<SurfacePart> & parts)
{
  std::map<std::string, int> counts;
  for (SurfacePart & part : parts)
  {
    const int count = ++counts[part.name];
    part.name += count > 1 ? " #" + std::to_string(count) : "";
  }
}

/** Maps arrays and parts from polygons to their triangles. */
void
CarryToTriangles(const PolygonSurface & polygons, const std::vector<int> & polygonOf, SurfaceFile & file)
{
  for (const SurfaceArray & array : polygons.cellArrays)
  {
    SurfaceArray carried{ array.name, {}, array.areIntegers };
    carried.values.resize(static_cast<Eigen::Index>(polygonOf.size()), array.values.cols());
    for (std::size_t t = 0; t < polygonOf.size(); ++t)
    {
      carried.values.row(static_cast<Eigen::Index>(t)) = array.values.row(polygonOf[t]);
    }
    file.mesh.cellArrays.push_back(std::move(carried));
  }
  for (const SurfacePart & part : polygons.parts)
  {
    const auto first = std::lower_bound(polygonOf.begin(), polygonOf.end(), part.firstFace);
    const auto last = std::lower_bound(polygonOf.begin(), polygonOf.end(), part.firstFace + part.numberOfFaces);
    if (first != last)
    {
      file.parts.push_back({ part.name, static_cast<int>(first - polygonOf.begin()), static_cast<int>(last - first) });
    }
  }
  NamePartsApart(file.parts);
}
} // namespace

void
RefuseSurface(const std::string & path, const std::string & fault, const std::string & advice)
{
  throw InputError("\"" + path + "\": " + Printable(fault) + "; " + advice); // the fault may quote bytes of the file
}

std::string
SurfaceExtension(const std::string & path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  return LowerCase(extension.erase(0, 1));
}

SurfaceFile
SurfaceOfPolygons(PolygonSurface && polygons, const std::string & path)
{
  CheckPolygons(polygons, path);
  SurfaceFile file;
  file.unit = polygons.unit;
  file.notes = std::move(polygons.notes);
  std::vector<int>       polygonOf;
  const std::vector<int> triangles = TrianglesOf(polygons, polygonOf);
  if (polygonOf.size() > polygons.ends.size())
  {
    file.notes.push_back("polygons were cut into triangles: " + std::to_string(polygons.ends.size()) +
                         " faces became " + std::to_string(polygonOf.size()));
  }
  file.mesh.V = Eigen::Map<const VertexMatrix>(polygons.points.data(), polygons.points.size() / 3, 3);
  file.mesh.F = Eigen::Map<const FaceMatrix>(triangles.data(), polygonOf.size(), 3);
  file.mesh.pointArrays = std::move(polygons.pointArrays);
  file.mesh.fieldArrays = std::move(polygons.fieldArrays);
  file.mesh.facts = std::move(polygons.facts);
  CarryToTriangles(polygons, polygonOf, file);
  RequireSound(file.mesh, "\"" + path + "\"");
  if (polygons.isRas)
  {
    file.mesh.V.leftCols<2>() *= -1.0;
  }
  if (polygons.unit == SurfaceUnit::Meter)
  {
    file.mesh.V *= 1000.0;
  }
  if (polygons.repeatsVertices)
  {
    MergeVertices(file.mesh);
  }
  return file;
}

SurfaceFile
ReadSurfaceFile(const std::string & path)
{
  using Reader = PolygonSurface (*)(const std::string &, const std::string &);
  static const std::map<std::string, Reader> readers{ { "vtp", ReadVtp }, { "stl", ReadStl }, { "obj", ReadObj },
                                                      { "ply", ReadPly }, { "off", ReadOff }, { "gltf", ReadGltf },
                                                      { "glb", ReadGltf } };
  const std::string                          bytes = ReadFileBytes(path);
  const auto                                 reader = readers.find(SurfaceExtension(path));
  if (reader == readers.end())
  {
    RefuseSurface(path, "not a surface format", "use a .vtp, .stl, .obj, .ply, .off, .gltf or .glb file");
  }
  if (bytes.empty())
  {
    RefuseSurface(path, "the file is empty");
  }
  return SurfaceOfPolygons(reader->second(bytes, path), path);
}
} // namespace shapeton
