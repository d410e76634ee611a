// A graph on a torus as a rotation system: faces, genus by Euler's formula, dual; writes a GraphML file.
// Usage: ExampleGraphModel GRAPH.graphml
#include "shapetonGraphFamilies.h"
#include "shapetonGraphReader.h"
#include "shapetonGraphStructure.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " GRAPH.graphml\n";
    return 2;
  }
  const shapeton::CombinatorialMap map = shapeton::TorusGridMap(5, 4, true); // 5 x 4 nodes, triangles
  std::cout << map.Nodes() << " nodes, " << map.Edges() << " edges, " << map.Faces() << " faces: genus " << map.Genus()
            << "; the dual has " << map.Dual().Nodes() << " nodes\n";
  std::cout << "neighbors of node 0, counter-clockwise:";
  for (const int halfEdge : map.Around(0))
  {
    std::cout << ' ' << map.Node(shapeton::CombinatorialMap::Twin(halfEdge));
  }

  shapeton::WriteGraphML(map.ToGraph(), argv[1]);
  const shapeton::GraphFile file = shapeton::ReadGraph(argv[1]); // or GML, DOT, METIS, ...
  std::cout << "\nread back as " << file.format << ": " << (file.graph.edges == map.ToGraph().edges ? "same" : "other")
            << " edges, " << shapeton::ConnectedComponents(file.graph).size() << " component" << '\n';
}
