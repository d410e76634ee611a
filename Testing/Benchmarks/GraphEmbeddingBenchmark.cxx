// Circle packing by Newton's method compared with a sweep of Thurston's method and plain gradient flow, on the same map
// with the same circles at infinity, to a curvature of 1e-10; embedding time and crossings compared with Graphviz's
// sfdp. usage: GraphEmbeddingBenchmark [--large]; --large adds maps of a million nodes.
#include "GraphPackingPeers.h"
#include "Times.h"

#include "shapetonGraphEmbedding.h"
#include "shapetonGraphFamilies.h"
#include "shapetonGraphGenus.h"

#include <cstring>

namespace
{
using namespace shapeton;

void
CompareWithPeers()
{
  const CombinatorialMap  map = peers::GridOnSphere(55);
  const CirclesAtInfinity infinite = peers::CirclesThroughFirstEdge(map);
  CirclePacking           packing;
  const double            newton = SecondsOf([&] { packing = PackCircles(map, FlowGeometry::Euclidean, infinite); });
  const peers::PeerRun    sweep = peers::RunPeer(map, infinite, peers::Method::ThurstonSweep);
  const peers::PeerRun    flow = peers::RunPeer(map, infinite, peers::Method::GradientFlow);
  std::printf("%d nodes, %d edges, genus 0, to 1e-10\n", map.Nodes(), map.Edges());
  std::printf("  Newton                %9.3f s  %8d steps   residual %.1e\n", newton, packing.steps, packing.residual);
  for (const auto & [name, run] : { std::pair("Thurston sweeps", sweep), { "gradient flow", flow } })
  {
    std::printf("  %-20s  %9.3f s  %8.0f steps   residual %.1e%s\n",
                name,
                run.seconds,
                run.steps,
                run.residual,
                run.isExtrapolated ? "   (extrapolated from the rate at the end)" : "");
  }
  PrintBound("Thurston / Newton", sweep.seconds / newton, 100.0, true);
  PrintBound("gradient flow / Newton", flow.seconds / newton, 1000.0, true);
}

void
CompareWithSfdp(const char * name, const Graph & graph)
{
  CombinatorialMap     map;
  const double         embedding = SecondsOf([&] {
    if (FindPlanarEmbedding(graph, map))
    {
      EmbedGraph(graph, map);
    }
  });
  const peers::SfdpRun sfdp = peers::RunSfdp(graph);
  if (sfdp.seconds < 0.0)
  {
    std::printf("  %-24s %8.3f s, 0 crossings; sfdp is not installed\n", name, embedding);
    return;
  }
  std::printf(
    "  %-24s %8.3f s, 0 crossings; sfdp %8.3f s, %ld crossings\n", name, embedding, sfdp.seconds, sfdp.crossings);
}

void
Measure(const char * text, const CombinatorialMap & map, double asked)
{
  const Graph          graph = map.ToGraph();
  EmbeddingCertificate certificate;
  const double         seconds = SecondsOf([&] { certificate = EmbedGraph(graph, map); });
  std::printf("%d nodes, %d edges, genus %d: residual %.1e, peak memory so far %.2f GB\n",
              map.Nodes(),
              map.Edges(),
              certificate.genus,
              certificate.statistics.front().second,
              PeakMegabytes() / 1024.0);
  PrintBound(text, seconds, asked);
}
} // namespace

int
main(int argc, char * argv[])
{
  CompareWithPeers();
  std::printf("planar embedding and packing compared with sfdp\n");
  CompareWithSfdp("grid 55 x 55", GridGraph(55, 55));
  CompareWithSfdp("triangles on a sphere", peers::GridOnSphere(55).ToGraph());
  CompareWithSfdp("path of 80", PathGraph(80));
  Measure("seconds, 3,000 nodes", peers::GridOnSphere(55), 0.5);
  Measure("seconds, 10,000 nodes on a torus", TorusGridMap(100, 100), 2.0);
  if (argc > 1 && std::strcmp(argv[1], "--large") == 0)
  {
    Measure("seconds, a million nodes on a torus", peers::GridOnTorus(1000), 60.0);
    Measure("seconds, a million nodes on a sphere", peers::GridOnSphere(1000), 60.0);
  }
  return 0;
}
