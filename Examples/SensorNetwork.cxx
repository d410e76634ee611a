// A network of moving devices, step by step: nodes and links appear and disappear. The Gabriel graph is always planar.
// Usage: ExampleSensorNetwork
#include "shapetonGraphGenus.h"
#include "shapetonSensorNetwork.h"

#include <iostream>

int
main()
{
  shapeton::SensorNetworkOptions options;
  options.nodes = 150;
  options.range = 150.0; // m
  options.speed = 20.0;  // m in a step
  shapeton::SensorNetwork network(options);

  int planarSteps = 0;
  for (int step = 0; step < 10; ++step)
  {
    const shapeton::Graph      graph = network.GetGraph(); // nodes are named after the devices
    shapeton::CombinatorialMap map;
    planarSteps += shapeton::FindPlanarEmbedding(graph, map);
    std::cout << "step " << step << ": " << graph.nodes << " devices, " << graph.edges.size() << " links\n";
    network.Advance();
  }
  std::cout << "planar in " << planarSteps << " of 10 steps\n";
}
