#include "shapetonJson.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonCsvTable.h"

#include <charconv>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr std::size_t MostLines = 10; // of each list; chosen

/** Nine digits: the last digits of a double depend on the math library. */
Json
Rounded(double value)
{
  if (!std::isfinite(value))
  {
    return nullptr;
  }
  const std::string text = CsvTable::Rounded(value, 9);
  double            rounded = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return rounded;
}

Json
ToJson(const SurfaceStatistics & statistics)
{
  Json json;
  json["minimum"] = Rounded(statistics.minimum);
  json["percentile1"] = Rounded(statistics.percentile1);
  json["median"] = Rounded(statistics.median);
  json["percentile99"] = Rounded(statistics.percentile99);
  json["maximum"] = Rounded(statistics.maximum);
  return json;
}

Json
ToJson(const Eigen::Vector3d & vector)
{
  return { Rounded(vector[0]), Rounded(vector[1]), Rounded(vector[2]) };
}

Json
ToJson(const std::optional<int> & number)
{
  return number ? Json(*number) : Json(nullptr);
}

Json
ToJson(const SurfaceComponent & component)
{
  Json json;
  json["faces"] = component.faces;
  json["vertices"] = component.vertices;
  json["edges"] = component.edges;
  json["boundaryLoops"] = component.boundaryLoops;
  json["eulerCharacteristic"] = component.eulerCharacteristic;
  json["manifold"] = component.isManifold;
  json["orientable"] = component.isOrientable;
  json["genus"] = ToJson(component.genus);
  return json;
}

/** Each kind of defect: JSON key, text, and count. */
struct DefectCount
{
  const char * key;
  const char * words;
  std::size_t  count;
};

std::vector<DefectCount>
CountsOf(const SurfaceDefects & defects)
{
  return { { "degenerateFaces", "degenerate faces", defects.degenerateFaces.size() },
           { "zeroAreaFaces", "faces without area", defects.zeroAreaFaces.size() },
           { "duplicateFaces", "duplicate faces", defects.duplicateFaces.size() },
           { "unreferencedVertices", "unreferenced vertices", defects.unreferencedVertices.size() },
           { "coincidentVertices", "coincident vertices", defects.coincidentVertices.size() },
           { "nonManifoldEdges", "non-manifold edges", defects.nonManifoldEdges.size() },
           { "nonManifoldVertices", "non-manifold vertices", defects.nonManifoldVertices.size() },
           { "inconsistentEdges", "edges with inconsistent orientation", defects.inconsistentEdges.size() } };
}

std::string
Line(const std::string & name, const std::string & value)
{
  return name + std::string(name.size() < 16 ? 16 - name.size() : 1, ' ') + value + '\n';
}

std::string
Short(double value)
{
  return CsvTable::Rounded(value, 6);
}

std::string
Text(const SurfaceStatistics & s, const std::string & unit)
{
  return Short(s.minimum) + ", 1 %: " + Short(s.percentile1) + ", median " + Short(s.median) +
         ", 99 %: " + Short(s.percentile99) + ", to " + Short(s.maximum) + unit;
}

std::string
Text(const SurfaceComponent & component)
{
  std::string text = std::to_string(component.faces) + " faces, " + std::to_string(component.boundaryLoops) +
                     " boundary loops, Euler characteristic " + std::to_string(component.eulerCharacteristic);
  if (!component.isManifold)
  {
    return text + ", not manifold";
  }
  return text + (component.genus ? ", genus " + std::to_string(*component.genus) : ", not orientable (one-sided)");
}

std::string
More(std::size_t number)
{
  return number > MostLines ? Line("", "and " + std::to_string(number - MostLines) + " more") : std::string();
}

std::string
ListOfComponents(const std::string & name, const std::vector<SurfaceComponent> & components)
{
  std::string text = Line(name, std::to_string(components.size()));
  for (std::size_t i = 0; i < std::min(components.size(), MostLines); ++i)
  {
    text += Line("", std::to_string(i + 1) + ": " + Text(components[i]));
  }
  return text + More(components.size());
}

Json
ToJson(const std::vector<SurfaceComponent> & components)
{
  Json list = Json::array();
  for (const SurfaceComponent & component : components)
  {
    list.push_back(ToJson(component));
  }
  return list;
}

std::string
Text(const Eigen::Vector3d & place)
{
  return "(" + Short(place[0]) + ", " + Short(place[1]) + ", " + Short(place[2]) + ")";
}

std::string
ListOfNonManifoldEdges(const SurfaceQuality & quality)
{
  std::string text;
  for (std::size_t i = 0; i < std::min(quality.nonManifoldEdges.size(), MostLines); ++i)
  {
    const auto & ends = quality.nonManifoldEdges[i];
    text += Line(i == 0 ? "Not manifold" : "", "edge from " + Text(ends[0]) + " to " + Text(ends[1]) + " mm");
  }
  return text + More(quality.nonManifoldEdges.size());
}

std::string
ListOfLoops(const SurfaceQuality & quality)
{
  std::string text = Line("Boundary loops", std::to_string(quality.boundaryLoopLengths.size()));
  for (std::size_t i = 0; i < std::min(quality.boundaryLoopLengths.size(), MostLines); ++i)
  {
    text += Line("",
                 std::to_string(i + 1) + ": " + std::to_string(quality.boundaryLoopVertices[i]) + " vertices, " +
                   Short(quality.boundaryLoopLengths[i]) + " mm");
  }
  return text + More(quality.boundaryLoopLengths.size());
}

std::string
ListOfDefects(const SurfaceDefects & defects)
{
  std::string text;
  for (const DefectCount & defect : CountsOf(defects))
  {
    if (defect.count)
    {
      text += Line(text.empty() ? "Defects" : "", std::to_string(defect.count) + ' ' + defect.words);
    }
  }
  return text.empty() ? Line("Defects", "none") : text;
}
} // namespace

Json
SurfaceQualityToJson(const SurfaceQuality & quality)
{
  Json json;
  json["vertices"] = quality.vertices;
  json["edges"] = quality.edges;
  json["faces"] = quality.faces;
  json["eulerCharacteristic"] = quality.eulerCharacteristic;
  json["genus"] = ToJson(quality.genus);
  json["manifold"] = quality.isManifold;
  json["closed"] = quality.isClosed;
  json["oriented"] = quality.isOriented;
  json["area"] = Rounded(quality.area);
  json["volume"] = quality.volume ? Rounded(*quality.volume) : Json(nullptr);
  json["extent"] = ToJson(quality.highestCorner - quality.lowestCorner);
  json["lowestCorner"] = ToJson(quality.lowestCorner);
  json["highestCorner"] = ToJson(quality.highestCorner);
  json["components"] = ToJson(quality.components);
  json["componentsAfterRepair"] =
    quality.componentsAfterRepair.empty() ? Json(nullptr) : ToJson(quality.componentsAfterRepair);
  json["boundaryLoops"] = Json::array();
  for (std::size_t i = 0; i < quality.boundaryLoopLengths.size(); ++i)
  {
    Json loop;
    loop["vertices"] = quality.boundaryLoopVertices[i];
    loop["length"] = Rounded(quality.boundaryLoopLengths[i]);
    json["boundaryLoops"].push_back(loop);
  }
  json["edgeLength"] = ToJson(quality.edgeLength);
  json["smallestAngle"] = ToJson(quality.smallestAngle);
  json["largestAngle"] = ToJson(quality.largestAngle);
  json["aspectRatio"] = ToJson(quality.aspectRatio);
  for (const DefectCount & defect : CountsOf(quality.defects))
  {
    json["defects"][defect.key] = defect.count;
  }
  json["nonManifoldEdges"] = Json::array();
  for (std::size_t i = 0; i < std::min(quality.nonManifoldEdges.size(), MostLines); ++i)
  {
    json["nonManifoldEdges"].push_back(
      { ToJson(quality.nonManifoldEdges[i][0]), ToJson(quality.nonManifoldEdges[i][1]) });
  }
  return json;
}

std::string
FormatSurfaceQuality(const SurfaceQuality & quality)
{
  const Eigen::Vector3d extent = quality.highestCorner - quality.lowestCorner;
  std::string           kind = quality.isManifold ? "manifold" : "not manifold";
  kind += quality.isClosed ? ", closed" : ", not closed";
  kind += quality.isOriented ? ", consistently oriented" : ", not consistently oriented";
  std::string text = Line("Faces", std::to_string(quality.faces));
  text += Line("Vertices", std::to_string(quality.vertices));
  text += Line("Edges", std::to_string(quality.edges));
  text += Line("Kind", kind);
  text += Line("Euler number", std::to_string(quality.eulerCharacteristic));
  text += Line("Genus", quality.genus ? std::to_string(*quality.genus) : "not defined");
  text += ListOfComponents("Components", quality.components);
  text += ListOfLoops(quality);
  text += Line("Extent", Short(extent[0]) + " x " + Short(extent[1]) + " x " + Short(extent[2]) + " mm");
  text += Line("Area", Short(quality.area) + " mm^2");
  text += Line("Volume", quality.volume ? Short(*quality.volume) + " mm^3" : "not defined");
  text += Line("Edge lengths", Text(quality.edgeLength, " mm"));
  text += Line("Smallest angles", Text(quality.smallestAngle, " degrees"));
  text += Line("Largest angles", Text(quality.largestAngle, " degrees"));
  text += Line("Aspect ratios", Text(quality.aspectRatio, ""));
  text += ListOfDefects(quality.defects) + ListOfNonManifoldEdges(quality);
  return quality.componentsAfterRepair.empty() ? text
                                               : text + ListOfComponents("After repair", quality.componentsAfterRepair);
}
} // namespace shapeton
