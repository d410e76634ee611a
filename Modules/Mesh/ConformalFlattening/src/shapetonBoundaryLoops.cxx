#include "shapetonBoundaryLoops.h"

#include "shapetonExceptions.h"

#include <algorithm>

namespace shapeton
{
namespace
{
double
LengthOfLoop(const std::vector<int> & loop, const VertexMatrix & V)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    length += (V.row(loop[i]) - V.row(loop[(i + 1) % loop.size()])).norm();
  }
  return length;
}

/** A boundary may visit a vertex twice, or end at an edge with three faces. */
void
RequireSimpleLoop(const SurfaceConnectivity & connectivity, const std::vector<int> & loop, std::vector<char> & isTaken)
{
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const int edge = connectivity.FindEdge(loop[i], loop[(i + 1) % loop.size()]);
    if (edge == -1 || !connectivity.IsBoundaryEdge(edge) || isTaken[loop[i]])
    {
      throw InputError("the boundary is not a simple closed curve at vertex " + std::to_string(loop[i]) +
                       "; repair the surface");
    }
    isTaken[loop[i]] = 1;
  }
}
} // namespace

std::vector<BoundaryLoop>
BoundaryLoopsByLength(const SurfaceConnectivity & connectivity, const VertexMatrix & V)
{
  std::vector<BoundaryLoop> loops;
  std::vector<char>         isTaken(connectivity.NumberOfVertices(), 0);
  for (const std::vector<int> & loop : connectivity.BoundaryLoops())
  {
    RequireSimpleLoop(connectivity, loop, isTaken);
    loops.push_back({ loop, LengthOfLoop(loop, V) });
  }
  std::stable_sort(
    loops.begin(), loops.end(), [](const BoundaryLoop & a, const BoundaryLoop & b) { return a.length > b.length; });
  return loops;
}

std::vector<int>
LoopOfVertices(const std::vector<BoundaryLoop> & loops, int numberOfVertices)
{
  std::vector<int> loopOf(numberOfVertices, -1);
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    for (const int vertex : loops[i].vertices)
    {
      loopOf[vertex] = static_cast<int>(i);
    }
  }
  return loopOf;
}

std::vector<int>
EarsOfLoops(const FaceMatrix & F, const std::vector<int> & loopOfVertices)
{
  std::vector<int> ears;
  for (int face = 0; face < F.rows(); ++face)
  {
    const int loop = loopOfVertices[F(face, 0)];
    if (loop != -1 && loopOfVertices[F(face, 1)] == loop && loopOfVertices[F(face, 2)] == loop)
    {
      ears.push_back(face);
    }
  }
  return ears;
}
} // namespace shapeton
