#include "shapetonSurfaceRicciFlow.h"

#include "shapetonCsvTable.h"
#include "shapetonJson.h"

namespace shapeton
{
namespace
{
/** Rounds to 9 significant digits, which hides rounding noise. */
double
Figure(double value)
{
  return std::stod(CsvTable::Rounded(value, 9));
}

/** Two coordinates; a value below 1e-9 of the other one is rounding noise. */
Json
PairToJson(double x, double y)
{
  constexpr double noise = 1e-9;
  return { std::abs(x) < noise * std::abs(y) ? 0.0 : Figure(x), std::abs(y) < noise * std::abs(x) ? 0.0 : Figure(y) };
}

Json
ConesToJson(const SurfaceRicciFlow & flow)
{
  constexpr double flat = 1e-9; // radians
  Json             list = Json::array();
  for (Eigen::Index v = 0; v < flow.targetCurvatures.size(); ++v)
  {
    if (std::abs(flow.targetCurvatures[v]) > flat)
    {
      list.push_back({ { "vertex", v }, { "curvature", Figure(flow.targetCurvatures[v]) } });
    }
  }
  return list;
}
} // namespace

Json
SurfaceRicciFlowToJson(const SurfaceRicciFlow & flow)
{
  Json json;
  json["scheme"] = flow.scheme == RicciScheme::VertexScaling ? "vertexScaling" : "inversiveDistance";
  json["geometry"] = flow.geometry == RicciGeometry::Euclidean    ? "euclidean"
                     : flow.geometry == RicciGeometry::Hyperbolic ? "hyperbolic"
                                                                  : "spherical";
  json["genus"] = flow.genus;
  json["boundaries"] = flow.boundaries;
  json["residual"] = flow.residual;
  json["steps"] = flow.steps;
  json["delaunayFlips"] = flow.delaunayFlips;
  json["flips"] = flow.flips;
  json["flippedFaces"] = flow.flippedFaces;
  json["area"] = Figure(flow.area);
  json["layoutResidual"] = flow.layoutResidual;
  json["smallestLogScale"] = Figure(flow.logScales.minCoeff());
  json["largestLogScale"] = Figure(flow.logScales.maxCoeff());
  json["cones"] = ConesToJson(flow);
  json["periods"] = Json();
  json["tau"] = Json();
  json["modulus"] = Json();
  if (!flow.periods.empty())
  {
    json["periods"] = Json::array();
    for (const Eigen::Vector2d & period : flow.periods)
    {
      json["periods"].push_back(PairToJson(period.x(), period.y()));
    }
    json["tau"] = PairToJson(flow.tau.real(), flow.tau.imag());
  }
  if (flow.modulus > 0.0)
  {
    json["modulus"] = Figure(flow.modulus);
  }
  return json;
}
} // namespace shapeton
