#include "shapetonConformalMap.h"

#include "shapetonCsvTable.h"
#include "shapetonJson.h"

namespace shapeton
{
namespace
{
const char *
RoleOf(const ConformalMap & map, int loop)
{
  return loop == map.outer ? "outer" : loop == map.inner ? "inner" : "slit";
}

/** Rounds to 9 significant digits, which hides rounding noise. */
double
Figure(double value)
{
  return std::stod(CsvTable::Rounded(value, 9));
}

Json
Figures(const Eigen::VectorXd & values)
{
  constexpr double rounding = 1e-12;
  Json             list = Json::array();
  for (const double value : values)
  {
    list.push_back(std::abs(value) < rounding ? 0.0 : Figure(value));
  }
  return list;
}

Json
BoundariesToJson(const ConformalMap & map)
{
  Json list = Json::array();
  for (std::size_t i = 0; i < map.loops.size(); ++i)
  {
    list.push_back({ { "number", i + 1 },
                     { "vertices", map.loops[i].vertices.size() },
                     { "length", Figure(map.loops[i].length) },
                     { "role", RoleOf(map, static_cast<int>(i)) } });
  }
  return list;
}

Json
SlitMapsToJson(const std::vector<SlitMap> & maps)
{
  Json list = Json::array();
  for (const SlitMap & map : maps)
  {
    list.push_back({ { "innerBoundary", map.inner + 1 },
                     { "modulusU", Figure(map.modulusU) },
                     { "modulusV", Figure(map.modulusV) },
                     { "logRadius", Figures(map.logRadiusOfLoops) },
                     { "turns", Figures(map.turnsOfLoops) } });
  }
  return list;
}
} // namespace

Json
ConformalMapToJson(const ConformalMap & map)
{
  Json document;
  document["faces"] = map.flat.NumberOfFaces();
  document["genus"] = map.genus;
  document["domain"] = WordOf(&ConformalMapOptions::domain, map.domain);
  document["boundaries"] = BoundariesToJson(map);
  document["outerBoundary"] = map.outer + 1;
  document["innerBoundary"] = map.inner == -1 ? Json() : Json(map.inner + 1);
  document["corners"] = map.corners;
  document["modulusU"] = Figure(map.modulusU);
  document["modulusV"] = Figure(map.modulusV);
  document["modulusGap"] = Figure(map.ModulusGap());
  document["flips"] = map.flips;
  document["flipsAtSlits"] = map.flipsAtSlits;
  document["solves"] = map.solves;
  document["ears"] = map.ears.size();
  document["dilatation"] = { { "median", Figure(map.dilatation.median) },
                             { "p95", Figure(map.dilatation.p95) },
                             { "p99", Figure(map.dilatation.p99) } };
  document["slitMaps"] = SlitMapsToJson(map.slitMaps);
  return document;
}
} // namespace shapeton
