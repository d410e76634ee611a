#ifndef shapetonWalkMeasure_h
#define shapetonWalkMeasure_h

#include "shapetonGraphStructure.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** A fraction between 0 and 1. */
struct Fraction
{
  std::int64_t numerator{ 0 };
  std::int64_t denominator{ 1 };
};

/** The simplest fraction that has this value as a double. \pre 0 <= value < 1. Throws ParameterError, with the name of
 * the parameter, if its denominator exceeds 2^31. */
Fraction
SimplestFraction(double value, const std::string & parameter);

/** Different neighbors of each node, ascending, with their numbers of parallel edges; loops are separate. */
class NeighborLists
{
public:
  struct Neighbor
  {
    int node;
    int edges;
  };

  explicit NeighborLists(const Graph & graph);

  const Neighbor *
  Begin(int node) const
  {
    return m_Neighbors.data() + m_Start[node];
  }
  const Neighbor *
  End(int node) const
  {
    return m_Neighbors.data() + m_Start[node + 1];
  }
  /** Half-edges of the node; a loop has two. */
  int
  Degree(int node) const
  {
    return m_Degrees[node];
  }
  /** Half-edges of the loops of the node. */
  int
  LoopEnds(int node) const
  {
    return m_LoopEnds[node];
  }
  /** Number of nodes adjacent to both. */
  int
  CommonNeighbors(int a, int b) const;

private:
  std::vector<std::size_t> m_Start;
  std::vector<Neighbor>    m_Neighbors;
  std::vector<int>         m_Degrees;
  std::vector<int>         m_LoopEnds;
};

/** Mass at a node. */
struct NodeMass
{
  int          node;
  std::int64_t mass;
};

/** The difference of the walks from the ends of an edge, as integers: what must leave the first end's neighborhood and
 * what must arrive in the other's. Mass common to both measures stays, which is optimal for a metric. */
struct MassTransfer
{
  std::vector<NodeMass> supplies;
  std::vector<NodeMass> demands;
  std::int64_t          total{ 0 }; ///< mass of each measure
};

/** Throws InputError if the masses exceed 64 bits. */
MassTransfer
TransferBetween(const NeighborLists & lists, int a, int b, const Fraction & idleness);
} // namespace shapeton

#endif
