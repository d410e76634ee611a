// Embeds graphs of known genus on surfaces of small genus: a cube, K7, the Petersen graph, K8. Usage: ExampleGraphGenus
#include "shapetonGraphFamilies.h"
#include "shapetonGraphGenus.h"

#include <iostream>

int
main()
{
  const std::pair<const char *, shapeton::Graph> graphs[] = {
    { "cube", shapeton::HypercubeGraph(3) },
    { "K7", shapeton::CompleteGraph(7) },
    { "Petersen", shapeton::GeneralizedPetersenGraph(5, 2) },
    { "K8", shapeton::CompleteGraph(8) },
  };
  for (const auto & [name, graph] : graphs)
  {
    const shapeton::SurfaceEmbedding embedding = shapeton::FindEmbedding(graph);
    std::cout << name << ": genus " << embedding.map.Genus() << (embedding.minimal ? ", proven minimal" : "") << ", "
              << embedding.map.Faces() << " faces\n";
  }
}
