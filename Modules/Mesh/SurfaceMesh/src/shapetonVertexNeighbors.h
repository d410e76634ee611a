#ifndef shapetonVertexNeighbors_h
#define shapetonVertexNeighbors_h

#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** End vertices of the outgoing edges of each vertex: all neighbors if the surface is closed and oriented. Requires far
 * less memory and time than SurfaceConnectivity. */
class VertexNeighbors
{
public:
  explicit VertexNeighbors(const SurfaceMesh & mesh)
    : m_Begin(static_cast<std::size_t>(mesh.NumberOfVertices()) + 1, 0)
    , m_Neighbors(static_cast<std::size_t>(mesh.NumberOfFaces()) * 3)
  {
    for (Eigen::Index i = 0; i < mesh.F.size(); ++i)
    {
      ++m_Begin[mesh.F.data()[i] + 1];
    }
    for (std::size_t i = 1; i < m_Begin.size(); ++i)
    {
      m_Begin[i] += m_Begin[i - 1];
    }
    std::vector<int> next(m_Begin.begin(), m_Begin.end() - 1);
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        m_Neighbors[next[mesh.F(f, k)]++] = mesh.F(f, (k + 1) % 3);
      }
    }
  }

  IndexRange
  operator[](int vertex) const
  {
    return { m_Neighbors.data() + m_Begin[vertex], m_Neighbors.data() + m_Begin[vertex + 1] };
  }

private:
  std::vector<int> m_Begin;
  std::vector<int> m_Neighbors;
};
} // namespace shapeton

#endif
