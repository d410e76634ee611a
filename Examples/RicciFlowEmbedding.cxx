// Embeds K7 on a flat torus by a circle packing: seven equal circles, each tangent to the six others.
// Usage: ExampleRicciFlowEmbedding
#include "shapetonGraphEmbedding.h"
#include "shapetonGraphFamilies.h"
#include "shapetonGraphGenus.h"

#include <algorithm>
#include <iostream>

int
main()
{
  const shapeton::Graph                graph = shapeton::CompleteGraph(7);
  const shapeton::CombinatorialMap     map = shapeton::FindEmbedding(graph).map; // a rotation system of genus 1
  const shapeton::EmbeddingCertificate embedding = shapeton::EmbedGraph(graph, map);

  const auto [smallest, largest] = std::minmax_element(embedding.nodeRadii.begin(), embedding.nodeRadii.end());
  std::cout << shapeton::NameOf(embedding.geometry) << ", " << embedding.faceRadii.size()
            << " faces; largest over smallest circle of a node: " << *largest / *smallest << "\nperiods of the torus:";
  for (const double coordinate : embedding.periods)
  {
    std::cout << ' ' << coordinate;
  }
  std::cout << '\n';
}
