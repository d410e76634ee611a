#ifndef shapetonBlockKernel_h
#define shapetonBlockKernel_h

#include "shapetonGraph.h"

#include <unordered_map>
#include <vector>

namespace shapeton
{
/** \class BlockKernel
 * \brief A 2-connected graph without its nodes of degree two and multiple edges, and the way back.
 *
 * A node of degree two becomes part of an edge, of parallel edges one is kept, until nothing changes: a simple graph
 * whose nodes have three neighbours or more is left, or one edge. Embeddings of it and of the whole have the same
 * genus.
 *
 * \ingroup GraphGenus */
class BlockKernel
{
public:
  /** `block` is 2-connected, or one edge that is no loop. */
  explicit BlockKernel(const Graph & block);

  const Graph &
  GetGraph() const
  {
    return m_Kernel;
  }

  /** From an embedding of the kernel, the half-edge after each one of the block. */
  std::vector<int>
  Expand(const std::vector<int> & kernelNextAround) const;

private:
  /** An edge of what is left: at both ends the half-edge of the block that begins it. */
  struct Edge
  {
    int node[2];
    int halfEdge[2];
  };
  /** What was done: the two half-edges of a node that became part of an edge, or an edge that was dropped beside the
   * one that was kept. */
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
