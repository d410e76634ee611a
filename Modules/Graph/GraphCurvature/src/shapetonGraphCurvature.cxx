#include "shapetonGraphCurvature.h"

#include "shapetonExceptions.h"
#include "shapetonParallelFor.h"
#include "shapetonShortTransport.h"

#include <limits>
#include <memory>
#include <numeric>

namespace shapeton
{
namespace
{
ExactNumber
Reduced(std::int64_t numerator, std::int64_t denominator)
{
  const std::int64_t divisor = std::gcd(numerator, denominator);
  return { numerator / divisor, denominator / divisor };
}

bool
IsLoop(const Graph & graph, std::size_t edge)
{
  return graph.edges[edge][0] == graph.edges[edge][1];
}

/** kappa of each edge, times `factor`. */
std::vector<ExactNumber>
TransportCurvatures(const Graph &         graph,
                    const NeighborLists & lists,
                    const Fraction &      idleness,
                    int                   factor,
                    const Progress &      progress)
{
  std::vector<ExactNumber>                     curvatures(graph.edges.size());
  std::vector<std::unique_ptr<ShortTransport>> transports(NumberOfThreads()); // one per worker, made on first use
  ParallelForWorkers(
    graph.edges.size(),
    [&](std::size_t edge, unsigned int worker) {
      if (IsLoop(graph, edge))
      {
        return;
      }
      if (!transports[worker])
      {
        transports[worker] = std::make_unique<ShortTransport>(lists, graph.nodes);
      }
      const auto [a, b] = graph.edges[edge];
      const MassTransfer transfer = TransferBetween(lists, a, b, idleness);
      const std::int64_t cost = transports[worker]->Cost(transfer);
      curvatures[edge] = Reduced(factor * (transfer.total - cost), transfer.total);
    },
    progress);
  return curvatures;
}

std::vector<ExactNumber>
CombinatorialCurvatures(const Graph &            graph,
                        const NeighborLists &    lists,
                        const std::vector<int> & triangles,
                        bool                     hasFaces)
{
  constexpr int            withoutNeighbors = 4; // twice the two ends
  constexpr int            perTriangle = 3;      // the face itself, and two edges that are no longer parallel
  std::vector<ExactNumber> curvatures(graph.edges.size());
  for (std::size_t edge = 0; edge < graph.edges.size(); ++edge)
  {
    const auto [a, b] = graph.edges[edge];
    if (a != b)
    {
      const std::int64_t degrees = static_cast<std::int64_t>(lists.Degree(a)) + lists.Degree(b);
      const std::int64_t faces = hasFaces ? triangles[edge] : 0;
      curvatures[edge] = { withoutNeighbors - degrees + perTriangle * faces, 1 };
    }
  }
  return curvatures;
}

void
AddUpAtNodes(const Graph & graph, GraphCurvature & curvature)
{
  std::vector<int> numbers(graph.nodes, 0);
  curvature.nodeSums.assign(graph.nodes, 0.0);
  for (std::size_t edge = 0; edge < graph.edges.size(); ++edge)
  {
    for (const int node : graph.edges[edge])
    {
      if (!IsLoop(graph, edge))
      {
        curvature.nodeSums[node] += curvature.edges[edge].Value();
        ++numbers[node];
      }
    }
  }
  curvature.nodeMeans.assign(graph.nodes, std::numeric_limits<double>::quiet_NaN());
  for (int node = 0; node < graph.nodes; ++node)
  {
    if (numbers[node] > 0)
    {
      curvature.nodeMeans[node] = curvature.nodeSums[node] / numbers[node];
    }
  }
}
} // namespace

double
ExactNumber::Value() const
{
  return this->IsDefined() ? static_cast<double>(numerator) / static_cast<double>(denominator)
                           : std::numeric_limits<double>::quiet_NaN();
}

std::string
ExactNumber::Text() const
{
  return !this->IsDefined() ? std::string()
         : denominator == 1 ? std::to_string(numerator)
                            : std::to_string(numerator) + '/' + std::to_string(denominator);
}

GraphCurvature
MeasureCurvature(const Graph & graph, const GraphCurvatureSettings & settings)
{
  RequireSound(graph, "the graph");
  CheckOptions(settings);
  RequireParameter(settings.method == CurvatureMethod::Ollivier || settings.idleness == 0.0,
                   "the parameter \"idleness\" applies only to the parameter \"method\" = ollivier");
  const NeighborLists lists(graph);
  GraphCurvature      curvature;
  curvature.triangles.assign(graph.edges.size(), 0);
  ParallelForBlocks(graph.edges.size(), [&](std::size_t edge) {
    const auto [a, b] = graph.edges[edge];
    curvature.triangles[edge] = a == b ? 0 : lists.CommonNeighbors(a, b);
  });
  switch (settings.method)
  {
    case CurvatureMethod::Ollivier:
      curvature.edges =
        TransportCurvatures(graph, lists, SimplestFraction(settings.idleness, "idleness"), 1, settings.progress);
      break;
    case CurvatureMethod::LinLuYau:
      curvature.edges = TransportCurvatures(graph, lists, { 1, 2 }, 2, settings.progress);
      break;
    default:
      curvature.edges =
        CombinatorialCurvatures(graph, lists, curvature.triangles, settings.method == CurvatureMethod::AugmentedForman);
  }
  AddUpAtNodes(graph, curvature);
  return curvature;
}
} // namespace shapeton
