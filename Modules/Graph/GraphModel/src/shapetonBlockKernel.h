#ifndef shapetonBlockKernel_h
#define shapetonBlockKernel_h

#include "shapetonGraph.h"

#include <unordered_map>
#include <vector>

namespace shapeton
{
/** \class BlockKernel
 * \brief Removes nodes of degree two and multiple edges from a 2-connected graph, and restores them.
 *
 * Nodes of degree two are contracted into edges, and one of several parallel edges is kept, until nothing changes. The
 * result is a simple graph of minimum degree three, or one edge. Embeddings of it and of the whole block have the same
 * genus.
 *
 * \ingroup ShapetonGraphModel */
class BlockKernel
{
public:
  /** \pre `block` is 2-connected, or a single edge that is not a loop. */
  explicit BlockKernel(const Graph & block);

  const Graph &
  GetGraph() const
  {
    return m_Kernel;
  }

  /** Returns the successor of each half-edge of the block from an embedding of the kernel. */
  std::vector<int>
  Expand(const std::vector<int> & kernelNextAround) const;

private:
  /** A kernel edge: the first block half-edge from each end. */
  struct Edge
  {
    int node[2];
    int halfEdge[2];
  };
  /** A reduction step: the two half-edges of a contracted node, or a dropped edge and its kept neighbor. */
  struct Step
  {
    bool isParallel;
    int  lost[2];
    int  kept[2];
  };

  void
  Add(const Edge & edge);
  void
  Suppress(int node);
  void
  BuildKernel();

  std::vector<Edge>                  m_Edges;
  std::vector<bool>                  m_Alive;
  std::vector<std::vector<int>>      m_Incident;
  std::vector<int>                   m_Degree;
  std::unordered_map<long long, int> m_EdgeOfPair;
  std::vector<int>                   m_Queue;
  std::vector<Step>                  m_Steps;
  std::size_t                        m_HalfEdges;
  Graph                              m_Kernel;
  std::vector<int>                   m_HalfEdgeOfKernel;
};
} // namespace shapeton

#endif
