// Planarity test of random triangulated grids compared with Boost's Boyer-Myrvold test, in one process; then the genus
// of known graphs. Argument: side of the grid (default 200).
#include "Times.h"

#include "shapetonGraphFamilies.h"
#include "shapetonGraphGenus.h"
#include "shapetonPhiloxStream.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

namespace
{
/** Grid with a random diagonal in each square, with shuffled nodes and edges. */
shapeton::Graph
TriangulatedGrid(int side)
{
  shapeton::PhiloxStream random(1, 0, 0);
  shapeton::Graph        graph = shapeton::GridGraph(side, side);
  for (int r = 0; r + 1 < side; ++r)
  {
    for (int c = 0; c + 1 < side; ++c)
    {
      const int node = r * side + c;
      graph.edges.push_back(random.Below(2) == 0 ? std::array<int, 2>{ node, node + side + 1 }
                                                 : std::array<int, 2>{ node + 1, node + side });
    }
  }
  std::vector<int> image(graph.nodes);
  std::iota(image.begin(), image.end(), 0);
  for (int i = graph.nodes; i > 1; --i)
  {
    std::swap(image[i - 1], image[random.Below(i)]);
  }
  graph = shapeton::RelabeledGraph(graph, image);
  for (int i = static_cast<int>(graph.edges.size()); i > 1; --i)
  {
    std::swap(graph.edges[i - 1], graph.edges[random.Below(i)]);
  }
  return graph;
}

/** Includes the embedding, like Shapeton's. */
bool
EmbedByBoost(const shapeton::Graph & graph)
{
  using BoostGraph = boost::adjacency_list<boost::vecS,
                                           boost::vecS,
                                           boost::undirectedS,
                                           boost::property<boost::vertex_index_t, int>,
                                           boost::property<boost::edge_index_t, int>>;
  BoostGraph boostGraph(graph.nodes);
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
  {
    boost::add_edge(graph.edges[e][0], graph.edges[e][1], static_cast<int>(e), boostGraph);
  }
  std::vector<std::vector<boost::graph_traits<BoostGraph>::edge_descriptor>> orders(graph.nodes);
  namespace parameters = boost::boyer_myrvold_params;
  return boost::boyer_myrvold_planarity_test(parameters::graph = boostGraph, parameters::embedding = orders.data());
}

void
ComparePlanarity(int side)
{
  const shapeton::Graph      graph = TriangulatedGrid(side);
  shapeton::CombinatorialMap map;
  bool                       planar = false;
  const double               ours = SecondsOf([&] { planar = shapeton::FindPlanarEmbedding(graph, map); });
  bool                       planarByBoost = false;
  const double               boosts = SecondsOf([&] { planarByBoost = EmbedByBoost(graph); });
  std::printf("planar embedding, %d nodes, %zu edges: %.3f s, genus %d; Boost %.3f s, ratio %.1f%s\n",
              graph.nodes,
              graph.edges.size(),
              ours,
              map.Genus(),
              boosts,
              boosts / ours,
              planar && planarByBoost ? "" : " NOT PLANAR");
}

void
MeasureSearch(const char * name, const shapeton::Graph & graph)
{
  shapeton::SurfaceEmbedding found;
  const double               seconds = SecondsOf([&] { found = shapeton::FindEmbedding(graph); });
  std::printf("%-22s genus %3d in %.2f s (lower bound %d)\n", name, found.map.Genus(), seconds, found.lowerBound);
  std::fflush(stdout);
}
} // namespace

int
main(int argc, char * argv[])
{
  ComparePlanarity(argc > 1 ? std::max(2, std::atoi(argv[1])) : 200);
  MeasureSearch("K7", shapeton::CompleteGraph(7));
  MeasureSearch("K12", shapeton::CompleteGraph(12));
  MeasureSearch("K15", shapeton::CompleteGraph(15));
  MeasureSearch("K8,8", shapeton::CompleteBipartiteGraph(8, 8));
  MeasureSearch("Q5", shapeton::HypercubeGraph(5));
  MeasureSearch("Q6", shapeton::HypercubeGraph(6));
  MeasureSearch("torus grid 12 x 12", shapeton::TorusGridMap(12, 12).ToGraph());
  return EXIT_SUCCESS;
}
