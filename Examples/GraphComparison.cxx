// Compares graphs: two numberings of the Petersen graph, then the Petersen graph and a prism with equally many edges.
// Usage: ExampleGraphComparison
#include "shapetonGraphComparison.h"
#include "shapetonGraphFamilies.h"

#include <iostream>

int
main()
{
  const shapeton::Graph petersen = shapeton::GeneralizedPetersenGraph(5, 2);
  const shapeton::Graph renumbered = shapeton::RelabeledGraph(petersen, { 4, 9, 0, 2, 7, 1, 8, 3, 6, 5 });
  const shapeton::Graph prism = shapeton::GeneralizedPetersenGraph(5, 1);
  for (const shapeton::Graph & other : { renumbered, prism })
  {
    const shapeton::GraphComparison comparison = shapeton::CompareGraphs(petersen, other); // embeds both
    std::cout << (comparison.isomorphic ? "isomorphic" : "not isomorphic") << ", genus " << comparison.a.genus
              << " and " << comparison.b.genus << ", nodes correspond by " << comparison.correspondence.by << '\n';
    for (const std::string & difference : comparison.differences)
    {
      std::cout << "  " << difference << '\n';
    }
  }
}
