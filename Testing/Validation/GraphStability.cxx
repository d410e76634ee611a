#include "GraphStability.h"

#include "GraphPackingPeers.h"

#include "shapetonDynamicEmbedding.h"
#include "shapetonGraphEmbedding.h"

#include <algorithm>
#include <cmath>
#include <complex>

using namespace shapeton;

namespace
{
using Places = std::vector<std::complex<double>>;

/** Removes some edges from the graph. */
Graph
Without(const Graph & graph, std::vector<std::size_t> gone)
{
  Graph rest{ graph.nodes, {}, graph.names };
  for (std::size_t edge = 0; edge < graph.edges.size(); ++edge)
  {
    if (std::find(gone.begin(), gone.end(), edge) == gone.end())
    {
      rest.edges.push_back(graph.edges[edge]);
    }
  }
  return rest;
}

/** Centers the layout and scales it to size 1. */
Places
Normalized(const std::vector<std::array<double, 2>> & layout)
{
  Places               places;
  std::complex<double> center = 0.0;
  for (const std::array<double, 2> & place : layout)
  {
    places.emplace_back(place[0], place[1]);
    center += places.back() / static_cast<double>(layout.size());
  }
  double square = 0.0;
  for (std::complex<double> & place : places)
  {
    place -= center;
    square += std::norm(place) / static_cast<double>(layout.size());
  }
  for (std::complex<double> & place : places)
  {
    place /= std::sqrt(square);
  }
  return places;
}

/** Mean distance of the unchanged nodes after the least-squares similarity, with reflection allowed. */
double
MeanDistance(const Places & a, const Places & b, const std::vector<char> & isChanged)
{
  double best = 1e300;
  for (const bool isMirrored : { false, true })
  {
    const auto           imageOf = [&](std::size_t i) { return isMirrored ? std::conj(b[i]) : b[i]; };
    std::complex<double> factor = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      factor += a[i] * std::conj(imageOf(i)) / static_cast<double>(a.size());
    }
    double sum = 0.0;
    double number = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      sum += isChanged[i] ? 0.0 : std::abs(a[i] - factor * imageOf(i));
      number += isChanged[i] ? 0.0 : 1.0;
    }
    best = std::min(best, sum / number);
  }
  return best;
}

double
SfdpDisplacement(const Graph & before, const Graph & after, const std::vector<int> & changedNodes)
{
  const peers::SfdpRun a = peers::RunSfdp(before, false);
  const peers::SfdpRun b = peers::RunSfdp(after, false);
  if (a.seconds < 0.0 || b.seconds < 0.0)
  {
    return -1.0;
  }
  std::vector<char> isChanged(before.nodes, 0);
  for (const int node : changedNodes)
  {
    isChanged[node] = 1;
  }
  return MeanDistance(Normalized(a.places), Normalized(b.places), isChanged);
}

/** Moves the barycenter of the circles to the center of the sphere, as without a previous step. */
EmbeddingCertificate
NotMoved(const EmbeddingCertificate & certificate)
{
  return EmbedPackedGraph(certificate.graph,
                          MapOfRotation(certificate.graph, certificate.rotation),
                          PackedMapOf(certificate),
                          PointAtInfinity::Circle);
}
} // namespace

GraphStability
MeasureStability(const Graph & graph, int edits, bool withSfdp)
{
  std::vector<std::size_t> gone[2];
  for (int k = 0; k < edits; ++k)
  {
    gone[k % 2].push_back((2 * k + 1) * graph.edges.size() / (2 * edits));
  }
  const Graph                before = Without(graph, gone[0]);
  const Graph                after = Without(graph, gone[1]);
  DynamicEmbedding           dynamic;
  const DynamicStep          first = dynamic.Add(before);
  const DynamicStep          second = dynamic.Add(after);
  const EmbeddingCertificate turned = NotMoved(second.certificate);
  GraphStability             stability;
  stability.unchangedNodes = second.changes.unchangedNodes;
  stability.moebius = second.changes.meanDisplacement;
  stability.rotation = ChangesBetween(first.certificate, turned).meanDisplacement;
  stability.sfdp = withSfdp ? SfdpDisplacement(before, after, second.changes.changedNodes) : -1.0;
  return stability;
}
