#ifndef shapetonPathsOfEdges_h
#define shapetonPathsOfEdges_h

#include <cstddef>
#include <vector>

namespace shapeton
{
/** The half-edges of a packed map along each edge of its graph; `subdivided` are the paths of edges with dummies. */
inline std::vector<std::vector<int>>
PathsOfEdges(std::size_t edges, const std::vector<std::vector<int>> & subdivided)
{
  std::vector<std::vector<int>> paths(edges);
  for (std::size_t edge = 0; edge < edges; ++edge)
  {
    paths[edge] = { static_cast<int>(2 * edge) };
  }
  for (const std::vector<int> & path : subdivided)
  {
    paths[path.front() / 2] = path;
  }
  return paths;
}
} // namespace shapeton

#endif
