// Ricci curvature of two triangles joined by an edge, and the conformal types of two triangular tilings.
// Usage: ExampleGraphCurvature
#include "shapetonConformalType.h"
#include "shapetonGraphCurvature.h"
#include "shapetonGraphFamilies.h"

#include <iostream>

int
main()
{
  const shapeton::Graph graph{ 6, { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 2, 3 }, { 3, 4 }, { 4, 5 }, { 5, 3 } }, {} };
  const auto            curvature = shapeton::MeasureCurvature(graph);
  for (std::size_t edge = 0; edge < graph.edges.size(); ++edge)
  {
    std::cout << graph.edges[edge][0] << '-' << graph.edges[edge][1] << ": " << curvature.edges[edge].Text() << '\n';
  }
  for (const int degree : { 6, 7 })
  {
    const auto result = shapeton::FindConformalType(shapeton::RegularTilingGraph(3, degree, 6));
    std::cout << "degree " << degree << ": " << NameOf(result.type) << '\n';
  }
}
