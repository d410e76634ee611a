#ifndef shapetonShortTransport_h
#define shapetonShortTransport_h

#include "shapetonWalkMeasure.h"

namespace shapeton
{
/** \brief Optimal transport of integer masses between the neighborhoods of two adjacent nodes.
 *
 * Distances are 1, 2 or 3, so successive shortest paths have three lengths: minimum cost flow needs one maximum flow
 * (Dinic) for paths of length 1 and one for length 2; the rest moves by 3. Pairs at distance 3 share one arc through a
 * hub. An object serves one thread, for edges of one graph. */
class ShortTransport
{
public:
  explicit ShortTransport(const NeighborLists & lists, int nodes) : m_Lists(lists), m_Marks(nodes, -1) {}

  /** Smallest sum of mass times distance. */
  std::int64_t
  Cost(const MassTransfer & transfer);

private:
  struct Arc
  {
    int          to;
    int          cost;
    std::int64_t room;
  };

  int
  MarkNeighbors(int node);
  int
  DistanceFromMark(int mark, int node) const;
  std::int64_t
  CostFrom(const NodeMass & single, const std::vector<NodeMass> & others);
  void
  Build(const MassTransfer & transfer);
  void
  Join(int from, int to, int cost, std::int64_t room);
  int
  FindDistances();
  bool
  FindLevels();
  std::int64_t
  Push(int node, std::int64_t most);
  std::int64_t
  MaximumFlow();

  const NeighborLists &         m_Lists;
  std::vector<int>              m_Marks; ///< of each node, see MarkNeighbors()
  int                           m_LastMark{ 0 };
  std::vector<Arc>              m_Arcs; ///< arc i and its reverse i ^ 1
  std::vector<std::vector<int>> m_Out;
  std::vector<int>              m_Distances;
  std::vector<int>              m_Levels;
  std::vector<std::size_t>      m_Next;
};
} // namespace shapeton

#endif
