#include "shapetonGraphCurvatureReport.h"

#include "shapetonGraphStructure.h"
#include "shapetonGrowthPlot.h"
#include "shapetonJson.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Fraction of white mixed into circles behind edges of the same color. */
constexpr double LightnessOfCircles = 0.55;

std::string
CellOf(double value)
{
  return std::isnan(value) ? std::string() : CsvTable::Number(value);
}

Json
Finite(double value)
{
  return std::isfinite(value) ? Json(value) : Json();
}

Json
EvidenceToJson(const TypeEvidence & evidence)
{
  Json json;
  json["type"] = NameOf(evidence.type);
  json["decay"] = Finite(evidence.decay);
  json["limit"] = Finite(evidence.limit);
  json["farLimit"] = Finite(evidence.farLimit);
  return json;
}

/** Largest magnitude of the curvature of an edge; 1 if all edges are flat. */
double
MagnitudeOf(const GraphCurvature & curvature)
{
  double most = 0.0;
  for (const ExactNumber & number : curvature.edges)
  {
    most = std::max(most, number.IsDefined() ? std::abs(number.Value()) : 0.0);
  }
  return most > 0.0 ? most : 1.0;
}
} // namespace

CsvTable
EdgeTableOf(const Graph & graph, const GraphCurvature & curvature)
{
  const Incidence incidence(graph);
  CsvTable        table({ "a", "b", "degreeA", "degreeB", "triangles", "curvature", "exact" });
  for (std::size_t edge = 0; edge < graph.edges.size(); ++edge)
  {
    const auto [a, b] = graph.edges[edge];
    const ExactNumber & number = curvature.edges[edge];
    table.AddRow({ NameOfNode(graph, a),
                   NameOfNode(graph, b),
                   std::to_string(incidence.Degree(a)),
                   std::to_string(incidence.Degree(b)),
                   number.IsDefined() ? std::to_string(curvature.triangles[edge]) : "",
                   CellOf(number.Value()),
                   number.Text() });
  }
  return table;
}

CsvTable
NodeTableOf(const Graph & graph, const GraphCurvature & curvature)
{
  const Incidence incidence(graph);
  CsvTable        table({ "node", "degree", "meanCurvature", "sumCurvature" });
  for (int node = 0; node < graph.nodes; ++node)
  {
    table.AddRow({ NameOfNode(graph, node),
                   std::to_string(incidence.Degree(node)),
                   CellOf(curvature.nodeMeans[node]),
                   CellOf(curvature.nodeSums[node]) });
  }
  return table;
}

std::string
NameOfCurvature(const GraphCurvatureOptions & options)
{
  switch (options.method)
  {
    case CurvatureMethod::Ollivier:
      return "Ollivier-Ricci curvature, idleness " + CsvTable::Number(options.idleness);
    case CurvatureMethod::LinLuYau:
      return "Lin-Lu-Yau curvature";
    case CurvatureMethod::Forman:
      return "Forman-Ricci curvature";
    default:
      return "augmented Forman-Ricci curvature";
  }
}

GraphView
ViewOfCurvature(const EmbeddingCertificate &  certificate,
                const GraphCurvature &        curvature,
                const GraphCurvatureOptions & options)
{
  const double most = MagnitudeOf(curvature);
  GraphView    view;
  view.certificate = &certificate;
  view.colorBar = GraphColorBar{ NameOfCurvature(options) + " (no unit)", most };
  for (const ExactNumber & number : curvature.edges)
  {
    view.edgeColors.push_back(DivergingColor(number.IsDefined() ? number.Value() / most : 0.0));
  }
  for (const double mean : curvature.nodeMeans)
  {
    view.nodeColors.push_back(DivergingColor(std::isnan(mean) ? 0.0 : mean / most, LightnessOfCircles));
  }
  return view;
}

std::vector<std::pair<std::string, std::string>>
FactsOf(const GraphCurvature & curvature)
{
  int                 negative = 0;
  int                 positive = 0;
  double              sum = 0.0;
  std::vector<double> values;
  for (const ExactNumber & number : curvature.edges)
  {
    if (number.IsDefined())
    {
      values.push_back(number.Value());
      sum += values.back();
      negative += number.numerator < 0 ? 1 : 0;
      positive += number.numerator > 0 ? 1 : 0;
    }
  }
  const auto                                       number = static_cast<int>(values.size());
  std::vector<std::pair<std::string, std::string>> facts{
    { "edges with negative curvature", std::to_string(negative) },
    { "edges with zero curvature", std::to_string(number - negative - positive) },
    { "edges with positive curvature", std::to_string(positive) }
  };
  if (number > 0)
  {
    constexpr int digits = 4;
    facts.emplace_back("least curvature", CsvTable::Rounded(*std::min_element(values.begin(), values.end()), digits));
    facts.emplace_back("largest curvature", CsvTable::Rounded(*std::max_element(values.begin(), values.end()), digits));
    facts.emplace_back("mean curvature", CsvTable::Rounded(sum / number, digits));
  }
  return facts;
}

CsvTable
BallTableOf(const ConformalTypeResult & result)
{
  CsvTable table({ "radius", "nodes", "boundaryNodes", "dummies", "rootRadius", "modulus", "resistance" });
  for (const PackedBall & ball : result.balls)
  {
    table.AddRow({ std::to_string(ball.radius),
                   std::to_string(ball.nodes),
                   std::to_string(ball.boundaryNodes),
                   std::to_string(ball.dummies),
                   CellOf(ball.rootRadius),
                   CellOf(ball.modulus),
                   CellOf(ball.resistance) });
  }
  return table;
}

void
WriteConformalTypeSvg(const ConformalTypeResult & result, const std::string & path)
{
  GrowthCurve modulus{ "modulus -log tanh(r / 2)", {}, {} };
  GrowthCurve resistance{ "resistance from root to boundary (edges)", {}, {} };
  for (const PackedBall & ball : result.balls)
  {
    modulus.radii.push_back(ball.radius);
    modulus.quantities.push_back(ball.modulus);
    resistance.quantities.push_back(ball.resistance);
  }
  resistance.radii = modulus.radii;
  WriteGrowthSvg({ modulus, resistance }, path);
}

Json
ConformalTypeToJson(const ConformalTypeResult & result, const std::string & rootName)
{
  Json json;
  json["root"] = rootName;
  json["type"] = NameOf(result.type);
  json["limitRadius"] = Json::array({ Finite(result.leastLimitRadius), Finite(result.limitRadius) });
  json["packing"] = EvidenceToJson(result.packing);
  json["resistance"] = EvidenceToJson(result.resistance);
  return json;
}
} // namespace shapeton
