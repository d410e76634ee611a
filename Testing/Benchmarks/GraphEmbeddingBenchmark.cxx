// Embedding time of triangulated grids on the sphere and the torus. usage: GraphEmbeddingBenchmark [--large]; --large
// adds maps of a million nodes. For the peers, see Utilities/run-validation graph-embedding.
#include "GraphPackingPeers.h"
#include "Times.h"

#include "shapetonGraphEmbedding.h"
#include "shapetonGraphFamilies.h"

#include <cstring>

namespace
{
using namespace shapeton;

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
  Measure("seconds, 3,000 nodes", peers::GridOnSphere(55), 0.5);
  Measure("seconds, 10,000 nodes on a torus", TorusGridMap(100, 100), 2.0);
  if (argc > 1 && std::strcmp(argv[1], "--large") == 0)
  {
    Measure("seconds, a million nodes on a torus", peers::GridOnTorus(1000), 60.0);
    Measure("seconds, a million nodes on a sphere", peers::GridOnSphere(1000), 60.0);
  }
  return 0;
}
